#include "infill/waves.hpp"

#include "infill/ruler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::infill {

namespace {

constexpr int kSteps = 32;    // knots per wave
constexpr double kWave = 2.4; // spacings per wave length, see docs/algorithms/infill.md
constexpr double kTau = 2 * std::numbers::pi;

// Radians per mm.
double scale(const Lines& o) { return kTau / (kWave * near_enough(o)); }

} // namespace

bool Waves::along_x(const Lines& o) {
    const double z = scale(o) * o.z;
    return std::abs(std::cos(z)) >= std::abs(std::sin(z));
}

Waves::Waves(const Lines& o, double lo, double hi) : step_(kTau / kSteps / scale(o)), period_(kTau / scale(o)) {
    const double mm = 1 / scale(o), z = scale(o) * o.z, s = near_enough(o);
    const double narrow = even_width(o, s) / s;
    const bool x = along_x(o);
    first_ = static_cast<std::int64_t>(std::floor(lo / step_)) - 1;
    const auto last = static_cast<std::int64_t>(std::ceil(hi / step_)) + 1;
    at_.reserve(static_cast<std::size_t>(last - first_ + 1));
    for (std::int64_t i = first_; i <= last; ++i) {
        const double t = static_cast<double>(i) * kTau / kSteps;
        const double a = x ? std::sin(t) : std::sin(z), b = x ? std::cos(z) : std::cos(t);
        const double c = x ? -std::sin(z) * std::cos(t) : -std::sin(t) * std::cos(z);
        const double middle = std::atan2(b, a), half = std::acos(std::clamp(c / std::hypot(a, b), -1.0, 1.0));
        const double cell = std::numbers::pi - half; // half the height of the even cell, around middle + pi
        const double centre = middle + std::numbers::pi;
        at_.push_back(narrow < 1 ? Pair{mm * (centre - narrow * cell), mm * (centre + narrow * cell)}
                                 : Pair{mm * (middle + half), mm * (middle + kTau - half)});
    }
}

std::int64_t Waves::column(double u) const {
    const auto c = static_cast<std::int64_t>(std::floor(u / step_));
    return std::clamp(c, first_, first_ + static_cast<std::int64_t>(at_.size()) - 2);
}

double Waves::at(std::int64_t column, double u, std::int64_t j) const {
    const auto i = static_cast<std::size_t>(column - first_);
    const double t = std::clamp((u - knot(column)) / step_, 0.0, 1.0);
    const double v =
        j % 2 == 0 ? std::lerp(at_[i].lower, at_[i + 1].lower, t) : std::lerp(at_[i].upper, at_[i + 1].upper, t);
    const std::int64_t cell = j >= 0 ? j / 2 : (j - 1) / 2;
    return v + static_cast<double>(cell) * period_;
}

std::int64_t Waves::below(std::int64_t column, double u, double v) const {
    auto j = 2 * static_cast<std::int64_t>(std::floor((v - at(column, u, 0)) / period_));
    while (at(column, u, j) > v) --j; // rounding
    while (at(column, u, j + 1) <= v) ++j;
    return j;
}

} // namespace filum::infill
