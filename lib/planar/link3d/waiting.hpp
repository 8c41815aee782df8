// Regions that wait to be printed, and the places where their curves can be entered.
#pragma once

#include "link3d/segment_index.hpp"
#include "toolpath/path.hpp"

#include <limits>
#include <optional>
#include <span>

namespace filum::link3d {

struct WaitingRegion {
    toolpath::RegionPaths paths;
    SegmentIndex index;
    double width;      // mm, mean of its curves
    double widest;     // mm, of its widest bead
    bool closed, open; // whether it has curves of this kind
};

WaitingRegion waiting(toolpath::RegionPaths region);

// Whether the input asks for a join from the region before.
inline bool goes_on(const WaitingRegion& r) { return r.paths.join != Join::start; }

// The place where a curve is entered. An open curve is entered at its first point, or at its last one if `against`.
struct Entry {
    Place place;
    bool against = false;
};

// The nearest place of a closed curve, or end of an open curve, that is at most `limit` mm from p. Curves with
// done[curve] != 0 are left out; an empty `done` leaves out none. Tie: closed curves first, then the lowest index.
std::optional<Entry> nearest_entry(const WaitingRegion& r, Vec2 p,
                                   double limit = std::numeric_limits<double>::infinity(),
                                   std::span<const char> done = {});

// The place, moved to a corner of the curve that is closer than kCorner. A shorter piece before a sharp corner would
// fold over its neighbours where programs round it. `from`: the point that distances are measured from.
Place at_corner(Place place, const toolpath::Curve& curve, Vec2 from);

} // namespace filum::link3d
