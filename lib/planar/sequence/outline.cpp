#include "sequence/outline.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <cmath>

namespace filum::sequence {

namespace {

using geom::Box2;
using geom::Capsule;
using geom::Vec2;

constexpr double kNeedle = 1e-3; // mm: without a head, regions this near are touched, as they are above or below
constexpr double kLevel = 1e-6;  // mm: heights this near are equal, since sums of layers are not exact
constexpr double kRay = 1e-6;    // mm: half the width of a ray, more than the rounding of capsules

inline double gap_x(const Box2& a, const Box2& b) { return std::max(0.0, std::max(a.lo.x - b.hi.x, b.lo.x - a.hi.x)); }
inline double gap_y(const Box2& a, const Box2& b) { return std::max(0.0, std::max(a.lo.y - b.hi.y, b.lo.y - a.hi.y)); }

bool may_reach(const Box2& a, const Box2& b, const Reach& r) {
    const double x = gap_x(a, b), y = gap_y(a, b);
    return x * x + y * y < r.radius * r.radius || (x < r.half_x && y < r.half_y);
}

// Whether two points of the segments differ by less than half_x in x and half_y in y, that is, whether the
// parallelogram of differences meets the open box; by the separating axes of both.
bool box_reaches(Vec2 a, Vec2 b, Vec2 c, Vec2 d, double half_x, double half_y) {
    const Vec2 u = b - a, v = d - c, m = 0.5 * (c + d) - 0.5 * (a + b);
    const auto apart = [&](Vec2 n) {
        const double extent = 0.5 * (std::abs(geom::dot(n, u)) + std::abs(geom::dot(n, v))) + std::abs(n.x) * half_x +
                              std::abs(n.y) * half_y;
        return std::abs(geom::dot(n, m)) >= extent;
    };
    return !apart({1, 0}) && !apart({0, 1}) && (u == Vec2{} || !apart(geom::left_of(u))) &&
           (v == Vec2{} || !apart(geom::left_of(v)));
}

// How far the segments a-b and c-d are apart along `axis`, times its length; negative if they overlap.
double apart(Vec2 axis, Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const double pa = geom::dot(axis, a), pb = geom::dot(axis, b), pc = geom::dot(axis, c), pd = geom::dot(axis, d);
    return std::max(std::min(pc, pd) - std::max(pa, pb), std::min(pa, pb) - std::max(pc, pd));
}

// The least larger coordinate of the difference between points of the segments a-b and c-d, as absolute value, where
// coordinates count by their shares. All differences are a parallelogram. Its distance from 0 by this norm is the
// greatest one along an axis, or across one of its sides: in the dual norm other directions lie between these.
double largest_difference(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Vec2 share) {
    double most = std::max({0.0, share.x * apart({1, 0}, a, b, c, d), share.y * apart({0, 1}, a, b, c, d)});
    for (const Vec2 side : {b - a, d - c}) {
        const double length = std::abs(side.y) / share.x + std::abs(side.x) / share.y; // of its normal
        if (length > 0) most = std::max(most, apart(geom::left_of(side), a, b, c, d) / length);
    }
    return most;
}

// The square of the distance between p and q on one side, and a segment on the other.
inline double squared_distance(Vec2 p, Vec2 q, Vec2 from, Vec2 to) {
    const Vec2 way = to - from, to_p = p - from, to_q = q - from;
    const double squared = geom::norm2(way), inverse = squared > 0 ? 1 / squared : 0;
    const double at_p = std::min(1.0, std::max(0.0, geom::dot(to_p, way) * inverse));
    const double at_q = std::min(1.0, std::max(0.0, geom::dot(to_q, way) * inverse));
    return std::min(geom::norm2(to_p - at_p * way), geom::norm2(to_q - at_q * way));
}

// Edge k of the loops, counted through all of them: from point k to the next of its loop.
struct EdgeCursor {
    const polygon::Loops& loops;
    std::size_t loop = 0;
    explicit EdgeCursor(const polygon::Loops& l, std::size_t k) : loops(l) {
        loop = static_cast<std::size_t>(std::upper_bound(l.start.begin(), l.start.end(), k) - l.start.begin()) - 1;
    }
    std::pair<Vec2, Vec2> at(std::size_t k) {
        while (k >= loops.start[loop + 1]) ++loop;
        return {loops.points[k], loops.points[k + 1 < loops.start[loop + 1] ? k + 1 : loops.start[loop]]};
    }
};

constexpr double kShare = 0.25; // of the difference to the limit, the error of a distance; it never affects a decision

// Both are lower bounds on the distance between edges of both runs, mm. From `enough` on, a simpler bound will do.
double gap(const Capsule& a, const Capsule& b, double enough) {
    if (a.radius < 0 || b.radius < 0) return std::numeric_limits<double>::infinity();
    const double thickness = a.radius + b.radius;
    const double boxes = std::max(apart({1, 0}, a.from, a.to, b.from, b.to), apart({0, 1}, a.from, a.to, b.from, b.to));
    if (boxes - thickness >= enough) return boxes - thickness;
    if (boxes <= 0 && geom::cross_properly(a.from, a.to, b.from, b.to)) return 0;
    return std::sqrt(
               std::min(squared_distance(a.from, a.to, b.from, b.to), squared_distance(b.from, b.to, a.from, a.to))) -
           thickness;
}
double carriage_gap(const Capsule& a, const Capsule& b, Vec2 share, double enough) {
    if (a.radius < 0 || b.radius < 0) return std::numeric_limits<double>::infinity();
    const double thickness = a.radius + b.radius;
    const double boxes = std::max(share.x * apart({1, 0}, a.from, a.to, b.from, b.to),
                                  share.y * apart({0, 1}, a.from, a.to, b.from, b.to));
    if (boxes - thickness >= enough) return boxes - thickness;
    return largest_difference(a.from, a.to, b.from, b.to, share) - thickness;
}

double size(const Capsule& c) { return std::abs(c.to.x - c.from.x) + std::abs(c.to.y - c.from.y) + 2 * c.radius; }

// Calls near(a, b, c, d) for pairs of edges whose runs are nearer than `wanted`, which near() may change; stops when it
// returns true. measure(x, y, enough) is a lower bound of the distance of two runs; from `enough` on its value does not
// matter. The nearer runs come first. Adds the pairs of capsules and edges to `steps`.
template <class Measure, class Near>
bool any_pair(const Outline& a, const Outline& b, std::uint64_t* steps, const double& wanted, Measure&& measure,
              Near&& near) {
    struct Runs {
        std::size_t i, j;
        double gap;
    };
    std::vector<Runs> pending{{0, 0, measure(a.edges[0], b.edges[0], wanted)}};
    std::uint64_t none = 0;
    std::uint64_t& count = steps != nullptr ? *steps : none;
    while (!pending.empty()) {
        const auto [i, j, least] = pending.back();
        pending.pop_back();
        if (least >= wanted) continue;
        const bool leaf_a = a.edges.leaf(i), leaf_b = b.edges.leaf(j);
        if (leaf_a && leaf_b) {
            const auto [a0, a1] = a.edges.run(i);
            const auto [b0, b1] = b.edges.run(j);
            count += (a1 - a0) * (b1 - b0);
            EdgeCursor ea(a.loops, a0);
            for (std::size_t k = a0; k < a1; ++k) {
                const auto [p, q] = ea.at(k);
                EdgeCursor eb(b.loops, b0);
                for (std::size_t l = b0; l < b1; ++l) {
                    const auto [s, t] = eb.at(l);
                    if (near(p, q, s, t)) return true;
                }
            }
            continue;
        }
        const bool halve_a = leaf_b || (!leaf_a && size(a.edges[i]) >= size(b.edges[j]));
        Runs first{halve_a ? 2 * i + 1 : i, halve_a ? j : 2 * j + 1, 0};
        Runs second{halve_a ? 2 * i + 2 : i, halve_a ? j : 2 * j + 2, 0};
        count += 2;
        for (Runs* r : {&first, &second}) r->gap = measure(a.edges[r->i], b.edges[r->j], wanted);
        if (first.gap < second.gap) std::swap(first, second);
        if (first.gap < wanted) pending.push_back(first);
        if (second.gap < wanted) pending.push_back(second); // the nearer one comes next
    }
    return false;
}

// Whether the region contains p: polygon::contains(), of the edges that the ray from p to the right may cross.
bool holds(const Outline& a, Vec2 p, std::uint64_t* steps) {
    const Box2& b = a.box;
    if (p.x < b.lo.x || p.x > b.hi.x || p.y < b.lo.y || p.y > b.hi.y) return false;
    const Box2 ray{p - Vec2{kRay, kRay}, Vec2{b.hi.x, p.y} + Vec2{kRay, kRay}};
    bool inside = false;
    a.edges.visit(ray, [&](geom::CapsuleTree::Run run) {
        EdgeCursor edge(a.loops, run.first);
        for (std::size_t k = run.first; k < run.last; ++k) {
            const auto [from, to] = edge.at(k);
            if ((from.y > p.y) == (to.y > p.y)) continue;
            if (p.x < from.x + (to.x - from.x) * (p.y - from.y) / (to.y - from.y)) inside = !inside;
        }
        if (steps != nullptr) *steps += run.last - run.first;
        return true;
    });
    return inside;
}

// Bounds of the least distance(p, q, s, t) of any two edges, as distance_bounds() gives them.
template <class Measure, class Distance>
Bounds bounds(const Outline& a, const Outline& b, double limit, Bounds known, std::uint64_t* steps, Measure&& measure,
              Distance&& distance) {
    if (!(known.least > 0) && (holds(a, b.loops.points[0], steps) || holds(b, a.loops.points[0], steps))) return {0, 0};
    double best = known.most, wanted = best; // runs that are farther apart than `wanted` are left out
    const auto want = [&] {
        if (best < std::numeric_limits<double>::infinity()) wanted = best - kShare * std::abs(best - limit);
    };
    want();
    any_pair(a, b, steps, wanted, measure, [&](Vec2 p, Vec2 q, Vec2 s, Vec2 t) {
        best = std::min(best, distance(p, q, s, t));
        want();
        return best == 0;
    });
    return {std::max({0.0, wanted, known.least}), best};
}

} // namespace

double Reach::farthest() const { return std::max({radius, half_x, half_y}); }

Reach reach(const machine::Head& head, double dz) {
    Reach r;
    r.radius = kNeedle;
    if (head.none) return r;
    r.radius = head.cone_radius(dz);
    if (dz > head.cone_height + kLevel) {
        r.half_x = head.carriage_x / 2;
        r.half_y = head.carriage_y / 2;
    }
    r.everywhere = dz > head.gantry_height + kLevel;
    return r;
}

Outline shifted(Outline o, geom::Vec2 way) {
    for (geom::Vec2& p : o.loops.points) p = p + way;
    o.edges.shift(way);
    if (!o.box.empty()) o.box = {o.box.lo + way, o.box.hi + way};
    return o;
}

Outline outline(polygon::Loops loops) {
    Outline o;
    o.loops = std::move(loops);
    o.box = polygon::bounds(o.loops);
    std::vector<geom::CapsuleTree::Segment> edges;
    EdgeCursor cursor(o.loops, 0);
    for (std::size_t k = 0; k < o.loops.points.size(); ++k) edges.push_back(cursor.at(k));
    o.edges = geom::CapsuleTree(edges);
    return o;
}

bool within(const Outline& a, const Outline& b, const Reach& r, std::uint64_t* steps) {
    if (r.everywhere) return true;
    if (!may_reach(a.box, b.box, r)) return false;
    if (holds(a, b.loops.points[0], steps) || holds(b, a.loops.points[0], steps)) return true;
    const auto near = [&](Vec2 p, Vec2 q, Vec2 s, Vec2 t) { return geom::segment_distance(p, q, s, t) < r.radius; };
    if (any_pair(a, b, steps, r.radius, gap, near)) return true;
    if (!(r.half_x > 0 && r.half_y > 0)) return false;
    const double half = std::min(r.half_x, r.half_y);
    const Vec2 share{half / r.half_x, half / r.half_y};
    return any_pair(
        a, b, steps, half,
        [&](const Capsule& x, const Capsule& y, double enough) { return carriage_gap(x, y, share, enough); },
        [&](Vec2 p, Vec2 q, Vec2 s, Vec2 t) { return box_reaches(p, q, s, t, r.half_x, r.half_y); });
}

Bounds distance_bounds(const Outline& a, const Outline& b, double limit, Bounds known, std::uint64_t* steps) {
    return bounds(a, b, limit, known, steps, gap, geom::segment_distance);
}

Bounds carriage_bounds(const Outline& a, const Outline& b, double half_x, double half_y, Bounds known,
                       std::uint64_t* steps) {
    const double half = std::min(half_x, half_y);
    const Vec2 share{half / half_x, half / half_y};
    return bounds(
        a, b, half, known, steps,
        [&](const Capsule& x, const Capsule& y, double enough) { return carriage_gap(x, y, share, enough); },
        [&](Vec2 p, Vec2 q, Vec2 s, Vec2 t) { return largest_difference(p, q, s, t, share); });
}

double distance(const Outline& a, const Outline& b) {
    if (holds(a, b.loops.points[0], nullptr) || holds(b, a.loops.points[0], nullptr)) return 0;
    double best = std::numeric_limits<double>::infinity();
    any_pair(a, b, nullptr, best, gap, [&](Vec2 p, Vec2 q, Vec2 s, Vec2 t) {
        best = std::min(best, geom::segment_distance(p, q, s, t));
        return best == 0;
    });
    return best;
}

} // namespace filum::sequence
