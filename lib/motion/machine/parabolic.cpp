#include "machine/parabolic.hpp"

#include <algorithm>
#include <cmath>

namespace filum::machine {

namespace {

constexpr double kCycle = 1e-3;       // s, cycle of the servo; a move takes at least one
constexpr double kCurveShare = 0.866; // largest share of the acceleration that an arc may need across the path
constexpr double kLeastCosine = 1e-3; // a flatter corner counts as straight

} // namespace

Parabolic::Parabolic(const Profile& p) : motion_(p.motion), axes_(p.axes) {}

Parabolic::Segment Parabolic::segment(const PlannedMove& m) const {
    Segment out;
    const double straight = norm(m.step), radius = m.sweep != 0 ? norm(m.arm) : 0;
    const bool linear = straight > 0 || radius > 0;
    out.length = m.sweep != 0 ? std::abs(m.sweep) * radius
                 : linear     ? straight
                              : std::max(std::abs(m.tilt), std::abs(m.turn));
    if (!(out.length > 0)) return out;
    const double l = out.length, laying = m.acceleration > 0 ? m.acceleration : motion_.acceleration,
                 a = m.extruding ? laying : motion_.travel_acceleration;
    double speed = linear ? std::min(m.feed, motion_.max_speed) : m.feed;
    double bound = std::min(along(motion_.acceleration_z, m.step.z, l), along(a, m.step.z, l));
    speed = std::min(speed, along(motion_.max_speed_z, m.step.z, l));
    if (m.sweep != 0)
        bound = std::min(bound, a);
    else
        bound = std::min({bound, along(a, m.step.x, l), along(a, m.step.y, l)});
    if (axes_.active()) {
        speed = std::min({speed, along(axes_.tilt_speed, m.tilt, l), along(axes_.turn_speed, m.turn, l)});
        bound = std::min({bound, along(axes_.tilt_acceleration, m.tilt, l), along(axes_.turn_acceleration, m.turn, l)});
    }
    out.acceleration = bound / 2;
    if (straight > 0) out.start = out.end = (1 / straight) * m.step;
    if (m.sweep != 0) {
        speed = std::min(speed, std::sqrt(kCurveShare * out.acceleration * radius));
        const double across = speed * speed / radius / out.acceleration;
        out.acceleration *= std::sqrt(std::max(0.0, 1 - across * across));
        const double way = m.sweep > 0 ? 1 / radius : -1 / radius, c = std::cos(m.sweep), s = std::sin(m.sweep);
        const geom::Vec2 end{c * m.arm.x - s * m.arm.y, s * m.arm.x + c * m.arm.y};
        out.start = {-way * m.arm.y, way * m.arm.x, 0};
        out.end = {-way * end.y, way * end.x, 0};
    }
    out.speed = std::min(speed, l / kCycle);
    return out;
}

// Runs the current segment to its end.  `next` begins while it slows down; null: there is no next segment.
void Parabolic::run(const Segment* next) {
    const Segment& s = at_;
    const double a = s.acceleration, left = std::max(s.length - begun_, 0.0);
    const double peak = std::min(s.speed, std::sqrt(a * left + speed_ * speed_ / 2));
    if (peak > speed_) {
        const double cruise = left - (2 * peak * peak - speed_ * speed_) / (2 * a);
        seconds_ += (2 * peak - speed_) / a + std::max(0.0, cruise) / peak;
    } else if (speed_ > 0) { // it is faster than it can brake
        seconds_ += std::max(speed_ / a, left > 0 ? left / speed_ : 0);
    }
    begun_ = speed_ = 0;
    if (next == nullptr) return;
    const Segment& n = *next;
    const double here = std::min(std::sqrt(a * s.length), s.speed);
    const double there = std::min(std::sqrt(n.acceleration * n.length), n.speed);
    // The longest blend that takes no more than half of either move.
    const double time =
        std::min(std::min(s.length / here, n.length / there), std::max(here / a, there / n.acceleration));
    double slows = std::min(here, time * a), grows = std::min(there, time * n.acceleration);
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1 - dot(s.end, n.start))));
    if (motion_.blend > 0 && cosine > kLeastCosine) {
        const double most = 2 * std::sqrt(a * motion_.blend / cosine);
        slows = std::min(slows, most);
        grows = std::min(grows, most);
    }
    if (!(slows > 0)) return;
    const double from = std::min(slows, std::max(peak, 0.0)), during = from / a;
    speed_ = std::min(grows * from / slows, n.acceleration * during);
    begun_ = std::min(speed_ * during / 2, n.length);
}

void Parabolic::move(const PlannedMove& m) {
    const Segment next = segment(m);
    if (!(next.length > 0)) return;
    if (any_) run(&next);
    at_ = next;
    any_ = true;
}

double Parabolic::total() {
    if (any_) run(nullptr);
    any_ = false;
    return seconds_;
}

} // namespace filum::machine
