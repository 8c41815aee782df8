#include "toolpath/reach.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace filum::toolpath {

namespace {

constexpr int kTries = 4; // until a longer one is off by little enough; it never is by more than the tolerance
constexpr double kNearly = 1.05, kLess = 0.9;

// The directions from a place in which a straight move meets each of some discs.
class Wedge {
  public:
    // Narrows it to those that meet the disc around `d` (from the place); else says on which side the disc lies: 1 to
    // the left of all, -1 to the right, and stays as it was.
    int take(Vec2 d, double radius) {
        const double away = geom::norm(d);
        if (away <= radius) return 0;
        const double s = radius / away, c = std::sqrt(1 - s * s);
        const Vec2 u = (1 / away) * d, l{u.x * c - u.y * s, u.x * s + u.y * c}, r{u.x * c + u.y * s, u.y * c - u.x * s};
        if (!any_) {
            any_ = true;
            left = l;
            right = r;
            return 0;
        }
        if (dot(u, left) + dot(u, right) <= 0) return geom::cross(left, u) + geom::cross(right, u) > 0 ? 1 : -1;
        if (geom::cross(left, r) > 0) return 1;
        if (geom::cross(right, l) < 0) return -1;
        if (geom::cross(left, l) < 0) left = l;
        if (geom::cross(right, r) > 0) right = r;
        return 0;
    }
    [[nodiscard]] bool holds(Vec2 d) const {
        return !any_ || (geom::cross(right, d) >= 0 && geom::cross(left, d) <= 0 && dot(left, d) + dot(right, d) > 0);
    }
    [[nodiscard]] bool any() const { return any_; }
    Vec2 left, right; // unit

  private:
    bool any_ = false;
};

// How far the straight move from `from.q` to `to.q` is from the line between both places: the Fréchet distance, from
// above; nothing if it is more than `most`.
std::optional<double> distance_of(const Line& line, const Place& from, const Place& to, double most) {
    const Vec2 way = to.q - from.q;
    const double length = norm(way), most2 = most * most;
    const Vec2 u = length > 0 ? (1 / length) * way : Vec2{1, 0};
    // Along the move: how far it is at the least, and if each point is abreast of the nearest place that is left.
    double least = 0, reached = 0, worst2 = 0;
    for (std::uint32_t k = from.i + 1; k < to.i + (to.t > 0 ? 1 : 0); ++k) {
        const Vec2 p = line.points[k].xy() - from.q;
        const double s = dot(p, u), off = geom::cross(u, p), off2 = off * off;
        if (off2 > most2) return std::nullopt;
        const double half = std::sqrt(most2 - off2);
        least = std::max(s - half, least);
        if (least > std::min(s + half, length)) return std::nullopt;
        reached = std::min(std::max(s, reached), length);
        worst2 = std::max(worst2, off2 + (s - reached) * (s - reached));
    }
    return std::min(most, std::sqrt(worst2));
}

double abreast(const Line& line, const Place& p) { // mm between q and its place on the line
    const Vec2 a = line.points[p.i].xy();
    return geom::distance(p.q, p.t > 0 ? geom::lerp(a, line.points[p.i + 1].xy(), p.t) : a);
}

// Where the ray from `q` along `u` leaves the band of half width `most` around the piece behind point j, seen from
// where it passes that point.
Place exit(const Line& line, Vec2 q, Vec2 u, std::uint32_t j, double most) {
    const Vec2 a = line.points[j].xy(), b = line.points[j + 1].xy();
    const double length = geom::distance(a, b);
    const Vec2 along = (1 / length) * (b - a), foot = q + dot(a - q, u) * u;
    const double aside = geom::cross(along, foot - a), leaving = geom::cross(along, u), forward = dot(along, u);
    Place out{j, 0, foot};
    if (!(forward > 0)) return out;
    // What is left of the piece is a move, or a part of one.
    const double to_end = (length - 2 * kLeastMove - dot(along, foot - a)) / forward;
    const double to_side = leaving != 0 ? ((leaving > 0 ? most : -most) - aside) / leaving : to_end;
    const Vec2 e = foot + std::max(0.0, std::min(to_end, to_side)) * u;
    const double t = dot(along, e - a) / length;
    if (t > 0 && t < 1) out = {j, t, e};
    return out;
}

Place reach_within(const Line& line, const Place& from, std::uint32_t last, const Tolerance& t, double& off) {
    const double most = t.path * (1 - 1e-9); // so that rounding leaves it within
    const bool free = !t.arcs;
    const auto point = [&](std::uint32_t k) { return line.points[k].xy(); };
    Wedge wedge;
    Section section(line, from, t.section);
    // The farthest points that some direction reaches, and that the direction to themselves does.
    std::uint32_t best = from.i + 1, exact = best, k = best;
    int side = 0;
    for (; k <= last; ++k) {
        side = wedge.take(point(k) - from.q, most);
        if (side != 0) break;
        section.take(k);
        if (!section.any()) break;
        if (!section.suits()) continue;
        const bool straight = wedge.holds(point(k) - from.q);
        if (straight) exact = k;
        if (straight || k < last) best = k;
    }
    const auto accept = [&](const Place& to) {
        const auto d = distance_of(line, from, to, t.path);
        const double end = abreast(line, to);
        if (!d || end > t.path) return false;
        // What is laid along a chord that is shorter is thicker.
        const double given = length_at(line, to) - length_at(line, from);
        if (given > (1 + t.section) * geom::distance(from.q, to.q)) return false;
        off = std::max({off, *d, end});
        return true;
    };
    if (free && side != 0 && k - 1 > from.i && best == k - 1) {
        const Place out = exit(line, from.q, side > 0 ? wedge.left : wedge.right, k - 1, most);
        // Worth it only if that is more than a corner cut off.
        const bool farther = exact < best || length_at(line, out) - line.at[best] > 2 * most;
        if (farther && out.i < last && section.suits_at(out) && accept(out)) return out;
    }
    if (free && best > exact) {
        const Vec2 way = point(best) - from.q, u = geom::cross(wedge.left, way) > 0 ? wedge.left : wedge.right;
        const Place out{best, 0, from.q + dot(way, u) * u};
        if (accept(out)) return out;
    }
    for (; exact > from.i + 1; exact = from.i + 1 + (exact - from.i - 1) / 2)
        if (const Place out{exact, 0, point(exact)}; accept(out)) return out;
    return {from.i + 1, 0, point(from.i + 1)};
}

} // namespace

Place straight_reach(const Line& line, const Place& from, std::uint32_t last, const Tolerance& t, double& off) {
    Tolerance now = t;
    Place to;
    for (int k = 0; k < kTries; ++k) {
        off = 0;
        to = reach_within(line, from, last, now, off);
        const double length = length_at(line, to) - length_at(line, from);
        const double may = t.path * full_share(line, from, length);
        if (off <= may * kNearly) break;
        // Of a circle the length goes with the root of what it may be off, so both with the power 3/2.
        now.path = std::min(std::pow(may / off, 2.0 / 3), kLess) * now.path;
    }
    return to;
}

} // namespace filum::toolpath
