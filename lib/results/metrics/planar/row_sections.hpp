// Sections of beads with rows: sets of intervals with exact ends.
#pragma once

#include "geom/vec.hpp"
#include "metrics/planar/cover.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace filum::metrics::planar {

using geom::Vec2;

// The most rows that sweep a layer.  Where the bead width alone decides, they are set farther apart to be no more.
inline constexpr double kMostRows = 200000;

struct Interval {
    double lo = 0, hi = 0;
    std::uint32_t slot = 0;
};

// A bead prepared for sections. Its y coordinates are in [lo, hi].
struct SweptBead {
    Vec2 a, b, u; // ends, direction
    double half = 0, length = 0, lo = 0, hi = 0;
    std::uint32_t slot = 0;
};

// By ascending lo.
std::vector<SweptBead> swept_beads(std::span<const Bead> beads);

// The section of the lane with the row at y, one interval because swept_beads are convex; false if it is empty.
bool section(const SweptBead& lane, double y, Interval& out);

// Adds an interval to united ones. It comes after all of them in the order of slots and positions.
inline void add_united(const Interval& next, std::vector<Interval>& to) {
    if (!to.empty() && to.back().slot == next.slot && next.lo <= to.back().hi)
        to.back().hi = std::max(to.back().hi, next.hi);
    else
        to.push_back(next);
}

// Sorts by slot and position, and unites intervals of a slot that overlap.
void unite(std::vector<Interval>& intervals);

} // namespace filum::metrics::planar
