// Arms for the tests, by tables that are written down here anew: none is read from the project's data.
#pragma once

#include "kinematics/arm.hpp"

#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace arms {

using namespace filum;
using geom::Frame;
using geom::Vec3;
using kinematics::Arm;
using kinematics::Axis;
using kinematics::kAxes;
using kinematics::Posture;
using std::numbers::pi;

struct Random {
    std::mt19937 engine{11};
    double operator()(double lo, double hi) { return lo + (hi - lo) * static_cast<double>(engine()) / 4294967296.0; }
};

inline std::array<Axis, kAxes> limits(double most) {
    std::array<Axis, kAxes> out;
    for (Axis& a : out) {
        a.min = -most;
        a.max = most;
        a.speed = pi;
    }
    return out;
}

// Universal Robots UR10e, the maker's table, mm.
inline Arm ur10e() {
    return kinematics::arm({{{0, 180.7, pi / 2, 0, 1},
                             {-612.7, 0, 0, 0, 1},
                             {-571.55, 0, 0, 0, 1},
                             {0, 174.15, pi / 2, 0, 1},
                             {0, 119.85, -pi / 2, 0, 1},
                             {0, 116.55, 0, 0, 1}}},
                           limits(2 * pi), {});
}

// An industrial robot by its lines: heights and offsets as data sheets draw them.
inline Arm industrial(double d1, double a1, double a2, double a3, double d4, double d6, double aside = 0) {
    auto axes = limits(pi);
    const auto line = [&](std::size_t k, Vec3 direction, Vec3 point) {
        axes[k].direction = direction;
        axes[k].point = point;
    };
    const double z = d1 + a2 + a3;
    line(0, {0, 0, 1}, {0, 0, 0});
    line(1, {0, 1, 0}, {a1, 0, d1});
    line(2, {0, 1, 0}, {a1, 0, d1 + a2});
    line(3, {1, 0, 0}, {a1, aside, z});
    line(4, {0, 1, 0}, {a1 + d4, aside, z});
    line(5, {1, 0, 0}, {a1 + d4, aside, z});
    return kinematics::arm(axes, {geom::about({0, 1, 0}, pi / 2), {a1 + d4 + d6, aside, z}});
}

inline std::vector<std::pair<std::string, Arm>> all() {
    Arm skew = industrial(400, 100, 600, 50, 500, 90);
    skew.axes[4].point.z += 40; // an offset wrist
    return {{"ur10e", ur10e()},
            {"irb", industrial(495, 175, 900, 175, 960, 135)},
            {"no offsets", industrial(300, 0, 500, 0, 500, 80)},
            {"aside", industrial(400, 30, 560, -35, 515, 80, 20)},
            {"general", kinematics::arm(skew.axes, skew.flange)}};
}

// A product of plain turns, written out: nothing of the project's kinematics.
inline Frame driven(const Arm& arm, const Posture& q) {
    Frame out = arm.flange;
    for (std::size_t k = kAxes; k-- > 0;) {
        const Axis& a = arm.axes[k];
        const double c = std::cos(q[k]), s = std::sin(q[k]);
        const auto spun = [&](const Vec3& v) {
            const Vec3& w = a.direction;
            const double along = v.x * w.x + v.y * w.y + v.z * w.z;
            const Vec3 x{w.y * v.z - w.z * v.y, w.z * v.x - w.x * v.z, w.x * v.y - w.y * v.x};
            return Vec3{c * v.x + s * x.x + (1 - c) * along * w.x, c * v.y + s * x.y + (1 - c) * along * w.y,
                        c * v.z + s * x.z + (1 - c) * along * w.z};
        };
        out = {{spun(out.turn.x), spun(out.turn.y), spun(out.turn.z)}, a.point + spun(out.origin - a.point)};
    }
    return out;
}

// How far two frames are apart, mm; a turn counts as it moves what is 100 mm off.
inline double off(const Frame& a, const Frame& b) {
    return distance(a.origin, b.origin) +
           100 * (distance(a.turn.x, b.turn.x) + distance(a.turn.y, b.turn.y) + distance(a.turn.z, b.turn.z));
}

} // namespace arms
