#include "sequence/drift.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::sequence {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr double kStraight = 2e-4; // mm; vertices are rounded to 1e-4 mm, so one on an edge may be this far off it

// Loops without vertices on the straight line between their neighbours, and how far removing these moved them.
struct SimplifiedLoops {
    polygon::Loops loops;
    double moved = 0; // mm, at most
};

SimplifiedLoops straight(const polygon::Loops& of) {
    SimplifiedLoops out;
    std::vector<geom::Vec2> kept;
    for (std::size_t l = 0; l < of.size(); ++l) {
        const auto loop = of[l];
        kept.clear();
        double moved = 0;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const auto before = kept.empty() ? loop.back() : kept.back();
            const auto after = k + 1 < loop.size() ? loop[k + 1] : kept.empty() ? loop[0] : kept.front();
            const double off = geom::point_segment_distance(before, after, loop[k]);
            if (off > kStraight)
                kept.push_back(loop[k]);
            else
                moved += off; // errors of consecutive vertices add up
        }
        out.loops.add(kept);
        out.moved = std::max(out.moved, moved);
    }
    return out;
}

bool same_loops(const polygon::Loops& a, const polygon::Loops& b) { return a.start == b.start && a.points == b.points; }

geom::Vec2 centre(std::span<const geom::Vec2> loop) {
    const geom::Box2 b = polygon::bounds(loop);
    return 0.5 * (b.lo + b.hi);
}

// Calls visit(from, to) for each vertex of `a` and the one of `b` that it moves to. Each loop is rotated so that its
// first vertex matches the nearest one, after the centre of its box has moved.
template <class Visit>
void each_vertex(const polygon::Loops& a, const polygon::Loops& b, const Visit& visit) {
    for (std::size_t l = 0; l < a.size(); ++l) {
        const auto from = a[l], to = b[l];
        const std::size_t n = from.size();
        if (n == 0) continue;
        const geom::Vec2 first = from[0] + centre(to) - centre(from);
        std::size_t nearest = 0;
        for (std::size_t k = 1; k < n && first != to[nearest]; ++k)
            if (geom::distance(first, to[k]) < geom::distance(first, to[nearest])) nearest = k;
        for (std::size_t k = 0; k < n; ++k) visit(from[k], to[k + nearest < n ? k + nearest : k + nearest - n]);
    }
}

// The shift is the middle of the box of all vertices' movements, so the rest is small.
Movement movement(const SimplifiedLoops& a, const SimplifiedLoops& b) {
    if (a.loops.start != b.loops.start) return {{}, kUnknown};
    geom::Box2 all;
    each_vertex(a.loops, b.loops, [&](geom::Vec2 from, geom::Vec2 to) { all.add(to - from); });
    Movement out;
    if (!all.empty()) out.shift = 0.5 * (all.lo + all.hi);
    each_vertex(a.loops, b.loops, [&](geom::Vec2 from, geom::Vec2 to) {
        out.rest = std::max(out.rest, geom::norm(to - from - out.shift));
    });
    out.rest += a.moved + b.moved;
    return out;
}

} // namespace

Movement movement(const polygon::Loops& a, const polygon::Loops& b) {
    if (same_loops(a, b)) return {};
    return movement(straight(a), straight(b));
}

double Drift::between(std::size_t i, std::size_t k) const {
    return known(i, k) ? std::abs(length[k] - length[i]) : kUnknown;
}

double relative(const Drift& a, std::size_t i, std::size_t k, const Drift& c, std::size_t m, std::size_t n) {
    if (!a.known(i, k) || !c.known(m, n)) return kUnknown;
    const geom::Vec2 apart = (a.shift[k] - a.shift[i]) - (c.shift[n] - c.shift[m]);
    return geom::norm(apart) + std::abs(a.rest[k] - a.rest[i]) + std::abs(c.rest[n] - c.rest[m]);
}

bool Drift::alone(std::size_t i) const {
    return (i == 0 || stretch[i - 1] != stretch[i]) && (i + 1 == stretch.size() || stretch[i + 1] != stretch[i]);
}

Drift drift(std::span<const Index> column, const std::vector<Outline>& outlines) {
    Drift out{{{}}, {0}, {0}, {0}};
    if (column.empty()) return out;
    SimplifiedLoops last = straight(outlines[column[0]].loops);
    for (std::size_t i = 1; i < column.size(); ++i) {
        SimplifiedLoops next = straight(outlines[column[i]].loops);
        const bool same = same_loops(outlines[column[i - 1]].loops, outlines[column[i]].loops);
        Movement by = same ? Movement{} : movement(last, next);
        last = std::move(next);
        const bool known = by.rest < kUnknown;
        if (!known) by = {};
        out.shift.push_back(out.shift.back() + by.shift);
        out.rest.push_back(out.rest.back() + by.rest);
        out.length.push_back(out.length.back() + geom::norm(by.shift) + by.rest);
        out.stretch.push_back(out.stretch.back() + (known ? 0 : 1));
    }
    return out;
}

} // namespace filum::sequence
