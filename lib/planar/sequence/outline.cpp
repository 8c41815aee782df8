#include "sequence/outline.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace filum::sequence {

namespace {

using geom::Box2;
using geom::Vec2;

constexpr std::size_t kRun = 2;  // edges per leaf
constexpr double kNeedle = 1e-3; // mm: without a head, regions this near are touched, as they are above or below
constexpr double kLevel = 1e-6;  // mm: heights this near are equal, since sums of layers are not exact

inline double gap_x(const Box2& a, const Box2& b) { return std::max(0.0, std::max(a.lo.x - b.hi.x, b.lo.x - a.hi.x)); }
inline double gap_y(const Box2& a, const Box2& b) { return std::max(0.0, std::max(a.lo.y - b.hi.y, b.lo.y - a.hi.y)); }

inline double squared_gap(const Box2& a, const Box2& b) {
    const double x = gap_x(a, b), y = gap_y(a, b);
    return x * x + y * y;
}

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

double largest(Vec2 p) { return std::max(std::abs(p.x), std::abs(p.y)); }

// The least larger coordinate of a point of the segment a-b, as absolute value: at an end, or where a coordinate is 0,
// or where both are equal.
double largest_of_segment(Vec2 a, Vec2 b) {
    double best = std::min(largest(a), largest(b));
    const Vec2 d = b - a;
    const auto ask = [&](double from, double slope) { // where from + t * slope is 0
        const double t = -from / slope;
        if (slope != 0 && t > 0 && t < 1) best = std::min(best, largest(a + t * d));
    };
    ask(a.x, d.x);
    ask(a.y, d.y);
    ask(a.x - a.y, d.x - d.y);
    ask(a.x + a.y, d.x + d.y);
    return best;
}

// The least larger coordinate of the difference between points of the segments a-b and c-d, as absolute value. All
// differences are a parallelogram, whose sides have an end of one of the segments.
double largest_difference(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (geom::cross_properly(a, b, c, d)) return 0;
    return std::min({largest_of_segment(c - a, d - a), largest_of_segment(c - b, d - b),
                     largest_of_segment(c - a, c - b), largest_of_segment(d - a, d - b)});
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

std::pair<std::size_t, std::size_t> run(const Outline& o, std::size_t node) {
    const std::size_t leaf = node - (o.leaves - 1), n = o.loops.points.size();
    return {std::min(n, leaf * kRun), std::min(n, (leaf + 1) * kRun)};
}

Box2 span(Vec2 p, Vec2 q) {
    return {{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}};
}

// Calls near(a, b, c, d) for pairs of edges whose boxes pass `open`; stops when it returns true. Adds the pairs of
// boxes and edges to `steps`.
template <class Open, class Near>
bool any_pair(const Outline& a, const Outline& b, std::uint64_t* steps, Open&& open, Near&& near) {
    std::vector<std::pair<std::size_t, std::size_t>> pending{{0, 0}};
    std::uint64_t none = 0;
    std::uint64_t& count = steps != nullptr ? *steps : none;
    while (!pending.empty()) {
        const auto [i, j] = pending.back();
        pending.pop_back();
        ++count;
        if (!open(a.box[i], b.box[j])) continue;
        const bool leaf_a = i + 1 >= a.leaves, leaf_b = j + 1 >= b.leaves;
        if (leaf_a && leaf_b) {
            const auto [a0, a1] = run(a, i);
            const auto [b0, b1] = run(b, j);
            count += (a1 - a0) * (b1 - b0);
            EdgeCursor ea(a.loops, a0);
            for (std::size_t k = a0; k < a1; ++k) {
                const auto [p, q] = ea.at(k);
                EdgeCursor eb(b.loops, b0);
                for (std::size_t l = b0; l < b1; ++l) {
                    const auto [s, t] = eb.at(l);
                    if (open(span(p, q), span(s, t)) && near(p, q, s, t)) return true;
                }
            }
            continue;
        }
        const auto size = [](const Box2& x) { return x.hi.x - x.lo.x + x.hi.y - x.lo.y; };
        const bool halve_a = leaf_b || (!leaf_a && size(a.box[i]) >= size(b.box[j]));
        std::pair<std::size_t, std::size_t> first{i, j}, second{i, j}; // the pairs of halves
        if (halve_a) {
            first.first = 2 * i + 1;
            second.first = 2 * i + 2;
        } else {
            first.second = 2 * j + 1;
            second.second = 2 * j + 2;
        }
        const auto gap = [&](const auto& pair) { return squared_gap(a.box[pair.first], b.box[pair.second]); };
        if (gap(first) < gap(second)) std::swap(first, second);
        pending.push_back(first);
        pending.push_back(second); // the nearer one comes next
    }
    return false;
}

bool holds(const Outline& a, Vec2 p, std::uint64_t* steps) {
    const Box2& b = a.box[0];
    if (p.x < b.lo.x || p.x > b.hi.x || p.y < b.lo.y || p.y > b.hi.y) return false;
    if (steps != nullptr) *steps += a.loops.points.size();
    return polygon::contains(a.loops, p);
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
    for (Box2& b : o.box)
        if (!b.empty()) b = {b.lo + way, b.hi + way};
    return o;
}

Outline outline(polygon::Loops loops) {
    Outline o;
    o.loops = std::move(loops);
    const std::size_t n = o.loops.points.size();
    o.leaves = std::bit_ceil(std::max<std::size_t>(1, (n + kRun - 1) / kRun));
    o.box.resize(2 * o.leaves - 1);
    EdgeCursor edges(o.loops, 0);
    for (std::size_t k = 0; k < n; ++k) {
        const auto [p, q] = edges.at(k);
        Box2& b = o.box[o.leaves - 1 + k / kRun];
        b.add(p);
        b.add(q);
    }
    for (std::size_t i = o.leaves - 1; i-- > 0;)
        for (const std::size_t c : {2 * i + 1, 2 * i + 2})
            if (!o.box[c].empty()) {
                o.box[i].add(o.box[c].lo);
                o.box[i].add(o.box[c].hi);
            }
    return o;
}

bool within(const Outline& a, const Outline& b, const Reach& r, std::uint64_t* steps) {
    if (r.everywhere) return true;
    if (!may_reach(a.box[0], b.box[0], r)) return false;
    if (holds(a, b.loops.points[0], steps) || holds(b, a.loops.points[0], steps)) return true;
    const bool box = r.half_x > 0 && r.half_y > 0;
    return any_pair(
        a, b, steps, [&](const Box2& x, const Box2& y) { return may_reach(x, y, r); },
        [&](Vec2 p, Vec2 q, Vec2 s, Vec2 t) {
            return geom::segment_distance(p, q, s, t) < r.radius ||
                   (box && box_reaches(p, q, s, t, r.half_x, r.half_y));
        });
}

double distance(const Outline& a, const Outline& b, std::uint64_t* steps) {
    if (holds(a, b.loops.points[0], steps) || holds(b, a.loops.points[0], steps)) return 0;
    double best = std::numeric_limits<double>::infinity(), squared = best;
    any_pair(
        a, b, steps, [&](const Box2& x, const Box2& y) { return squared_gap(x, y) < squared; },
        [&](Vec2 p, Vec2 q, Vec2 s, Vec2 t) {
            best = std::min(best, geom::segment_distance(p, q, s, t));
            squared = best * best;
            return best == 0;
        });
    return best;
}

double carriage_distance(const Outline& a, const Outline& b, double half_x, double half_y, std::uint64_t* steps) {
    if (holds(a, b.loops.points[0], steps) || holds(b, a.loops.points[0], steps)) return 0;
    const double shorter = std::min(half_x, half_y);
    const Vec2 share{shorter / half_x, shorter / half_y};
    const auto seen = [&](Vec2 p) { return Vec2{share.x * p.x, share.y * p.y}; };
    double best = std::numeric_limits<double>::infinity();
    any_pair(
        a, b, steps,
        [&](const Box2& x, const Box2& y) { return std::max(share.x * gap_x(x, y), share.y * gap_y(x, y)) < best; },
        [&](Vec2 p, Vec2 q, Vec2 s, Vec2 t) {
            best = std::min(best, largest_difference(seen(p), seen(q), seen(s), seen(t)));
            return best == 0;
        });
    return best;
}

} // namespace filum::sequence
