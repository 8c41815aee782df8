// Angles in radians and in degrees.
#pragma once

#include <cmath>
#include <numbers>

namespace filum::geom {

// Radians in one degree: 5 * kDegree is an angle of five degrees.
inline constexpr double kDegree = std::numbers::pi / 180;

// Converts between degrees and radians. radians(d) may differ from d * kDegree in the last bit.
constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double degrees(double radians) { return radians * 180 / std::numbers::pi; }

// `angle` plus the multiple of 2 pi that brings it nearest to `to`, rad.
inline double unwrapped(double angle, double to) {
    return angle + 2 * std::numbers::pi * std::round((to - angle) / (2 * std::numbers::pi));
}

// `angle` minus a multiple of 2 pi, in (-pi, pi].
inline double wrapped(double angle) {
    const double a = std::remainder(angle, 2 * std::numbers::pi);
    return a <= -std::numbers::pi ? a + 2 * std::numbers::pi : a;
}

} // namespace filum::geom
