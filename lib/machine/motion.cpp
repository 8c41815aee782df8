#include "machine/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::machine {

namespace {

// Square of the speed at which a corner may be passed; `c` is the cosine between the one direction and the next.
double corner_speed2(double c, double shorter, double acceleration, double square_corner) {
    if (c > 0.999999) return 1e30;
    const double half_sine = std::sqrt(std::max(0.0, 0.5 * (1 + c))); // sine of half the angle between the arms
    if (half_sine < 1e-6) return 0;                                   // turns back
    const double radius_part = half_sine / (1 - half_sine);
    const double deviation = square_corner * square_corner * (std::numbers::sqrt2 - 1) / acceleration;
    const double tangent = half_sine / std::sqrt(std::max(1e-12, 0.5 * (1 - c)));
    return std::min(radius_part * deviation * acceleration, 0.5 * shorter * tangent * acceleration);
}

double leg_time(double length, double feed2, double a, double in2, double out2) {
    const double peak2 = std::max({in2, out2, std::min(feed2, a * length + (in2 + out2) / 2)});
    const double peak = std::sqrt(peak2), in = std::sqrt(in2), out = std::sqrt(out2);
    const double cruise = std::max(0.0, length - (2 * peak2 - in2 - out2) / (2 * a));
    return (peak - in) / a + (peak - out) / a + cruise / peak;
}

} // namespace

Clock::Clock(const Motion& motion) : motion_(motion) { legs_.reserve(2 * kAhead); }

void Clock::move(geom::Vec3 step, double feed, bool extruding) {
    const double length = geom::norm(step);
    if (!(length > 0)) return;
    double top = std::min(feed, motion_.max_speed);
    if (step.z != 0) top = std::min(top, motion_.max_speed_z * length / std::abs(step.z));
    const double a = extruding ? motion_.acceleration : motion_.travel_acceleration;
    Leg leg{length, top * top, a, 0, 0, (1 / length) * step};
    if (!legs_.empty()) {
        const Leg& before = legs_.back();
        const double corner = corner_speed2(dot(before.direction, leg.direction), std::min(before.length, length),
                                            std::min(a, before.acceleration), motion_.corner_speed);
        leg.corner2 = std::min({corner, leg.feed2, before.feed2});
    }
    legs_.push_back(leg);
    if (legs_.size() == 2 * kAhead) settle(kAhead);
}

void Clock::pause(double seconds) {
    settle(legs_.size());
    seconds_ += seconds;
}

double Clock::total() {
    settle(legs_.size());
    return seconds_;
}

void Clock::settle(std::size_t count) {
    double out2 = 0;
    for (std::size_t i = legs_.size(); i-- > 0;) {
        Leg& leg = legs_[i];
        leg.entry2 = std::min(i == 0 ? speed2_ : leg.corner2, out2 + 2 * leg.acceleration * leg.length);
        out2 = leg.entry2;
    }
    double in2 = legs_.empty() ? 0 : legs_.front().entry2;
    for (std::size_t i = 0; i < count; ++i) {
        const Leg& leg = legs_[i];
        const double limit2 = i + 1 < legs_.size() ? legs_[i + 1].entry2 : 0;
        const double next2 = std::min(limit2, in2 + 2 * leg.acceleration * leg.length);
        seconds_ += leg_time(leg.length, leg.feed2, leg.acceleration, in2, next2);
        in2 = next2;
    }
    legs_.erase(legs_.begin(), legs_.begin() + static_cast<long>(count));
    speed2_ = in2;
}

} // namespace filum::machine
