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

// Displacement between the loops, vertex by vertex; each is rotated so that its first vertex matches the nearest one.
double vertex_displacement(const polygon::Loops& a, const polygon::Loops& b) {
    if (a.start != b.start) return kUnknown;
    double most = 0;
    for (std::size_t l = 0; l < a.size(); ++l) {
        const auto from = a[l], to = b[l];
        const std::size_t n = from.size();
        std::size_t shift = 0;
        for (std::size_t k = 1; k < n && from[0] != to[shift]; ++k)
            if (geom::distance(from[0], to[k]) < geom::distance(from[0], to[shift])) shift = k;
        for (std::size_t k = 0; k < n; ++k)
            most = std::max(most, geom::distance(from[k], to[k + shift < n ? k + shift : k + shift - n]));
    }
    return most;
}

double displacement(const SimplifiedLoops& a, const SimplifiedLoops& b) {
    return vertex_displacement(a.loops, b.loops) + a.moved + b.moved;
}

} // namespace

double displacement(const polygon::Loops& a, const polygon::Loops& b) {
    if (same_loops(a, b)) return 0;
    return displacement(straight(a), straight(b));
}

double Drift::between(std::size_t i, std::size_t k) const {
    return stretch[i] == stretch[k] ? std::abs(moved[k] - moved[i]) : kUnknown;
}

bool Drift::alone(std::size_t i) const {
    return (i == 0 || stretch[i - 1] != stretch[i]) && (i + 1 == stretch.size() || stretch[i + 1] != stretch[i]);
}

Drift drift(std::span<const Index> column, const std::vector<Outline>& outlines) {
    Drift out{{0}, {0}};
    if (column.empty()) return out;
    SimplifiedLoops last = straight(outlines[column[0]].loops);
    for (std::size_t i = 1; i < column.size(); ++i) {
        SimplifiedLoops next = straight(outlines[column[i]].loops);
        const bool same = same_loops(outlines[column[i - 1]].loops, outlines[column[i]].loops);
        const double by = same ? 0 : displacement(last, next);
        last = std::move(next);
        const bool known = by < kUnknown;
        out.moved.push_back(out.moved.back() + (known ? by : 0));
        out.stretch.push_back(out.stretch.back() + (known ? 0 : 1));
    }
    return out;
}

} // namespace filum::sequence
