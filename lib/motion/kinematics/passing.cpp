#include "kinematics/passing.hpp"

#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>

namespace filum::kinematics {

namespace {

using geom::Frame;

constexpr double kLook = 10 * geom::kDegree; // largest rotation of an axis from sample to sample
constexpr int kFollowHalvings = 7;           // most halvings of a move; if an axis still turns more, it is a jump

} // namespace

void Follower::look(const Posture& q, JointMove& p) const {
    const Nearness n = nearness(c_.arm, q);
    if (n.angle < p.nearest.angle) p.nearest = n;
    for (std::size_t k = 0; k < kAxes; ++k) {
        const double room = std::min(q[k] - c_.arm.axes[k].min, c_.arm.axes[k].max - q[k]);
        if (room < p.room) {
            p.room = room;
            p.room_axis = k;
        }
    }
}

JointMove Follower::pass(const Frame& a, const Posture& from, const Frame& b) const {
    JointMove out;
    out.to = from;
    piece(a, from, b, 0, 1, 0, out);
    return out;
}

std::vector<Posture> Follower::ways(const Frame& tip, const Posture& near, Shortfall* lack) const {
    return inverse(c_.arm, tip * back_, near, lack);
}

// The posture at `tip` that is nearest to `near`.
std::optional<Posture> Follower::on(const Frame& tip, const Posture& near, JointMove& p) const {
    if (c_.arm.build == Build::general) {
        constexpr int steps = 20;
        auto q = refined(c_.arm, tip * back_, near, steps);
        if (!q) p.hindrance = {FollowFailure::reach, 0, 0, 0};
        return q;
    }
    Shortfall lack;
    std::optional<Posture> best;
    for (const Posture& way : ways(tip, near, &lack)) {
        const Posture q = unwrapped(way, near);
        if (!best || apart(q, near) < apart(*best, near)) best = q;
    }
    if (!best) p.hindrance = {FollowFailure::reach, 0, lack.axis, lack.length};
    return best;
}

// Continues from share `begin`, where the posture is p.to, to `end`; false if that is impossible.
bool Follower::piece(const Frame& a, const Posture from, const Frame& b, double begin, double end, int depth,
                     JointMove& p) const {
    const auto to = on(end < 1 ? between(a, b, end) : b, from, p);
    if (!to) return false;
    const double turned = apart(*to, from);
    if (turned > kLook) {
        if (depth < kFollowHalvings) {
            const double middle = (begin + end) / 2;
            return piece(a, from, b, begin, middle, depth + 1, p) && piece(a, p.to, b, middle, end, depth + 1, p);
        }
        for (std::size_t k = 0; k < kAxes; ++k)
            if (std::abs((*to)[k] - from[k]) == turned) p.hindrance = {FollowFailure::jump, 0, k, turned};
        return false;
    }
    // A controller keeps the configuration along a straight move.
    if (!(configuration(c_.arm, *to) == configuration(c_.arm, from))) {
        p.nearest = nearness(c_.arm, *to);
        p.hindrance = {FollowFailure::jump, 0, 2 * static_cast<std::size_t>(p.nearest.which), turned};
        return false;
    }
    look(*to, p);
    for (std::size_t k = 0; k < kAxes; ++k) {
        const double time = std::abs((*to)[k] - from[k]) / c_.arm.axes[k].speed / (end - begin);
        if (time > p.needed) {
            p.needed = time;
            p.axis = k;
        }
    }
    p.to = *to;
    if (p.room >= 0) return true;
    p.hindrance = {FollowFailure::limit, 0, p.room_axis, -p.room};
    return false;
}

Frame spun(const Frame& tip, double spin) {
    const double c = std::cos(spin), s = std::sin(spin);
    const geom::Vec3 &x = tip.turn.x, &y = tip.turn.y;
    return {{c * x + s * y, c * y - s * x, tip.turn.z}, tip.origin};
}

Frame between(const Frame& a, const Frame& b, double share) {
    const auto v = geom::rotation_vector(b.turn * geom::inverse(a.turn));
    const geom::Vec3 axis{v[0], v[1], v[2]};
    const double angle = norm(axis);
    Frame out{a.turn, a.origin + share * (b.origin - a.origin)};
    if (angle > 0) out.turn = geom::about(1 / angle * axis, share * angle) * a.turn;
    return out;
}

} // namespace filum::kinematics
