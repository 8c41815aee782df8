// Regions that wait to be printed, and where their curves can be entered.
#pragma once

#include "link3d/segment_index.hpp"
#include "toolpath/path.hpp"

#include <limits>
#include <optional>
#include <span>

namespace filum::link3d {

struct Waiting {
    toolpath::RegionPaths paths;
    SegmentIndex index;
    double width;      // mm, mean of its beads
    bool closed, open; // has curves of this kind
};

Waiting waiting(toolpath::RegionPaths region);

// Whether a region is to be reached from the one before.
inline bool goes_on(const Waiting& r) { return r.paths.join != Join::start; }

// Where a curve is entered: for an open one at its first point, or its last.
struct Entry {
    Place place;
    bool against = false;
};

// The nearest place of a closed curve or end of an open one that is at most `limit` mm from p, of those not done (all,
// if `done` is empty).  Tie: closed curves first, then by index.
std::optional<Entry> nearest_entry(const Waiting& r, Vec2 p, double limit = std::numeric_limits<double>::infinity(),
                                   std::span<const char> done = {});

// The place, at a corner of the curve if that is nearer than kCorner: a shorter piece before a sharp corner would fold
// over its neighbours where machine code rounds it.  `from`: where it was asked for.
Place at_corner(Place place, const toolpath::Curve& curve, Vec2 from);

} // namespace filum::link3d
