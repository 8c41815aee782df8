#include "machine/look_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::machine {

namespace {

constexpr double kAnySpeed2 = 1e30;
constexpr std::size_t kHeld = 2048; // legs planned together where the look-ahead has no limit
// How firmware other than Klipper divides arcs: chords per circle; shortest and longest chord, mm.
constexpr double kPieces = 72, kShortest = 0.1, kLongest = 1;

double trapezoid(double length, double a, double in2, double cruise2, double out2) {
    const double peak2 = std::max({in2, out2, std::min(cruise2, a * length + (in2 + out2) / 2)});
    const double peak = std::sqrt(peak2), in = std::sqrt(in2), out = std::sqrt(out2);
    const double cruise = std::max(0.0, length - (2 * peak2 - in2 - out2) / (2 * a));
    return (peak - in) / a + (peak - out) / a + cruise / peak;
}

double squared(double v) { return v * v; }

} // namespace

LookAhead::LookAhead(const Profile& p) : motion_(p.motion), axes_(p.axes) {
    // The deviation times the acceleration a.  The circle that touches both legs of a square corner deviates from it by
    // r (sqrt 2 - 1).  At corner_speed v it has r = v2 / a.
    deviation_ = squared(motion_.corner_speed) * (std::numbers::sqrt2 - 1);
    ahead_ =
        motion_.look_ahead > 0 ? std::min<std::size_t>(static_cast<std::size_t>(motion_.look_ahead), kHeld) : kHeld;
    legs_.reserve(2 * kHeld);
}

// Square of the speed that the jumps of the extruder and the rotary axes allow at a corner.
double LookAhead::jump2(const Leg& before, const Leg& leg) const {
    double out = kAnySpeed2;
    const auto axis = [&](double from, double to, double bound) {
        if (const double change = std::abs(to - from); change > 0) out = std::min(out, squared(bound / change));
    };
    axis(before.extruded, leg.extruded, motion_.extruder_corner_speed);
    axis(before.tilt, leg.tilt, axes_.tilt_corner_speed);
    axis(before.turn, leg.turn, axes_.turn_corner_speed);
    return out;
}

// Square of the highest speed at the corner between two legs.
double LookAhead::corner2(const Leg& before, const Leg& leg) const {
    if (!before.linear || !leg.linear) return 0;
    const double jump = jump2(before, leg);
    if (motion_.controller == Controller::reprapfirmware) {
        const geom::Vec3 d = leg.direction - before.direction;
        const double most = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        return most > 0 ? std::min(jump, squared(motion_.corner_speed / most)) : jump;
    }
    const double c = dot(before.direction, leg.direction), a = std::min(before.acceleration, leg.acceleration);
    const double half_sine = std::sqrt(std::max(0.0, 0.5 * (1 + c))); // sine of half the angle between the legs
    const double half_cosine = std::sqrt(std::max(0.0, 0.5 * (1 - c)));
    if (half_sine >= 1 || half_cosine == 0) return jump;
    const double part = half_sine / (1 - half_sine), tangent = half_sine / half_cosine;
    if (motion_.controller == Controller::linuxcnc) {
        constexpr double normal = 0.866; // share of the acceleration that a blend leaves to the curve
        return std::min({jump, part * motion_.blend * normal * a,
                         0.5 * std::min(before.length, leg.length) * tangent * normal * a});
    }
    // The circle must touch the legs before their middles.
    const double rule = part * deviation_ * std::min(before.share, leg.share);
    return std::min({jump, rule, 0.25 * tangent * std::min(before.gain2, leg.gain2)});
}

void LookAhead::move(const PlannedMove& m) {
    if (m.sweep == 0) return straight(m);
    const double radius = norm(m.arm);
    const double piece = motion_.controller == Controller::klipper
                             ? motion_.arc_resolution
                             : std::clamp(2 * std::numbers::pi * radius / kPieces, kShortest, kLongest);
    const int n = std::max(1, static_cast<int>(std::abs(m.sweep) * radius / piece));
    PlannedMove part = m;
    part.sweep = 0;
    part.extruded = m.extruded / n;
    geom::Vec2 at = m.arm;
    for (int k = 1; k <= n; ++k) {
        const double angle = m.sweep * k / n, c = std::cos(angle), s = std::sin(angle);
        const geom::Vec2 to{c * m.arm.x - s * m.arm.y, s * m.arm.x + c * m.arm.y};
        part.step = {to.x - at.x, to.y - at.y, m.step.z / n};
        straight(part);
        at = to;
    }
}

void LookAhead::straight(const PlannedMove& m) {
    Leg leg;
    leg.length = norm(m.step);
    leg.linear = leg.length > 0;
    if (!leg.linear) leg.length = std::max(std::abs(m.tilt), std::abs(m.turn));
    if (!(leg.length > 0)) return;
    const double l = leg.length;
    if (leg.linear) leg.direction = (1 / l) * m.step;
    leg.extruded = m.extruded / l;
    leg.tilt = m.tilt / l;
    leg.turn = m.turn / l;
    double speed = leg.linear ? std::min(m.feed, motion_.max_speed) : m.feed;
    const double laying = m.acceleration > 0 ? m.acceleration : motion_.acceleration;
    double a = m.extruding ? laying : motion_.travel_acceleration;
    if (!leg.linear) a = std::numeric_limits<double>::infinity();
    speed = std::min(speed, along(motion_.max_speed_z, m.step.z, l));
    a = std::min(a, along(motion_.acceleration_z, m.step.z, l));
    if (axes_.active()) {
        speed = std::min({speed, along(axes_.tilt_speed, m.tilt, l), along(axes_.turn_speed, m.turn, l)});
        a = std::min({a, along(axes_.tilt_acceleration, m.tilt, l), along(axes_.turn_acceleration, m.turn, l)});
    }
    leg.acceleration = a;
    leg.cruise2 = speed * speed;
    leg.gain2 = 2 * a * l;
    const bool gently = motion_.controller == Controller::klipper;
    // If the acceleration is changed, Klipper keeps the corner speed, and Marlin keeps the deviation.
    leg.share = a / (gently && !m.extruding ? motion_.travel_acceleration : laying);
    leg.gentle2 = gently ? std::min(leg.gain2, 2 * l * laying * (1 - motion_.minimum_cruise_ratio)) : leg.gain2;
    if (!legs_.empty()) {
        const Leg& before = legs_.back();
        leg.corner2 = std::min({corner2(before, leg), leg.cruise2, before.cruise2});
        leg.most2 = std::min(leg.corner2, before.most2 + before.gain2);
        leg.smooth2 = std::min(leg.most2, before.smooth2 + before.gentle2);
    } else {
        leg.corner2 = leg.most2 = speed2_;
        leg.smooth2 = smooth2_;
    }
    legs_.push_back(leg);
    if (legs_.size() == 2 * kHeld) settle(kHeld);
}

double LookAhead::total() {
    settle(legs_.size());
    return seconds_;
}

// Plans the speed at the start of every leg, with all legs as look-ahead.
void LookAhead::plan_entries() {
    double out2 = 0;
    for (std::size_t i = legs_.size(); i-- > 0;) {
        Leg& leg = legs_[i];
        leg.entry2 = std::min(leg.most2, out2 + leg.gain2);
        out2 = leg.entry2;
    }
}

// Plans the speed at the start of every leg, with a look-ahead of `ahead_` legs: the machine must be able to stop at
// the end of the last of them.
void LookAhead::plan_window() {
    for (std::size_t i = 0; i < legs_.size(); ++i) {
        double out2 = 0;
        for (std::size_t k = std::min(legs_.size(), i + ahead_); k-- > i;)
            out2 = std::min(legs_[k].most2, out2 + legs_[k].gain2);
        legs_[i].entry2 = out2;
    }
}

void LookAhead::time_trapezoids(std::size_t count) {
    double in2 = legs_.front().entry2;
    for (std::size_t i = 0; i < count; ++i) {
        const Leg& leg = legs_[i];
        const double next2 = std::min(i + 1 < legs_.size() ? legs_[i + 1].entry2 : 0, in2 + leg.gain2);
        seconds_ += trapezoid(leg.length, leg.acceleration, in2, leg.cruise2, next2);
        in2 = next2;
    }
    speed2_ = in2;
}

// Adds the time of legs as Klipper plans them.  The peak of each stretch is where speeding up and braking by gentle2
// only would meet.  The legs between peaks keep the speed of the leg before, or slow down.
void LookAhead::time_smoothed(std::size_t count) {
    const std::size_t n = legs_.size();
    constexpr double unset = -1;
    std::vector<double> cruise2(n, unset);
    double out2 = 0, smooth2 = 0, peak2 = 0;
    std::size_t pending = 0;
    for (std::size_t i = n; i-- > 0;) {
        const Leg& leg = legs_[i];
        const double reach2 = out2 + leg.gain2, gently2 = smooth2 + leg.gentle2,
                     begin2 = std::min(leg.smooth2, gently2);
        ++pending;
        if (begin2 < gently2) { // it can speed up
            if (begin2 + leg.gentle2 > smooth2 || pending > 1) peak2 = (begin2 + gently2) / 2;
            cruise2[i] = std::min({(leg.entry2 + reach2) / 2, leg.cruise2, peak2});
            pending = 0;
        }
        out2 = leg.entry2;
        smooth2 = begin2;
    }
    double before2 = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Leg& leg = legs_[i];
        const double c2 = cruise2[i] == unset ? std::min(before2, leg.entry2) : cruise2[i];
        const double next2 = i + 1 < n ? legs_[i + 1].entry2 : 0;
        const double in2 = std::min(leg.entry2, c2), end2 = std::min(next2, c2);
        if (c2 > 0) seconds_ += trapezoid(leg.length, leg.acceleration, in2, c2, end2);
        before2 = c2;
    }
}

void LookAhead::settle(std::size_t count) {
    if (count == 0) return;
    ahead_ < kHeld ? plan_window() : plan_entries();
    motion_.controller == Controller::klipper ? time_smoothed(count) : time_trapezoids(count);
    if (count < legs_.size()) {
        if (motion_.controller == Controller::klipper) speed2_ = legs_[count].entry2;
        smooth2_ = legs_[count].smooth2;
        legs_[count].most2 = legs_[count].corner2 = speed2_;
    } else {
        speed2_ = smooth2_ = 0;
    }
    legs_.erase(legs_.begin(), legs_.begin() + static_cast<long>(count));
}

} // namespace filum::machine
