// The rings of a region, all that a fill needs of this folder.
#pragma once

#include "rings/rings.hpp"
#include "toolpath/path.hpp"

#include <numbers>

namespace filum::rings {

// Of its width squared, what the round end of a bead leaves open in a right-angled corner: smaller voids are not worth
// a detour.
inline constexpr double kLeastVoid = (1 - std::numbers::pi / 4) / 4;

// The share of a small region that voids too small for a detour may leave open together.
inline constexpr double kMostOpen = 1.0 / 100;

// The smallest void that counts in a region of `area` mm2, mm2: what the edge of a bead of `width` flows over, or a
// tenth of kMostOpen of the region where that is less.
double least_void(double width, double area);

struct LaneOptions {
    double width = 0.4;      // mm, of a bead where nothing asks for another
    int most = 0;            // lanes from the outline; 0: until the region is full
    double tolerance = 0.01; // mm: how far the edges of beads may be off
};

// Rings along the lanes of the region (outer loop, then holes): closed, none crossing another or itself, each point
// with the width of its lane there.  They share the region: their beads leave nothing out but tips and corners smaller
// than what the edge of a bead flows over, and than the thousandth part of the region.
Rings lanes(const Loops& region, const LaneOptions& options);

// The first lanes and what they leave.
struct FirstLanes {
    Rings lanes;
    std::vector<Loops> rest; // connected parts, each its outer loop, then its holes; in the order of polygon::split
};

// Lanes 1 to o.most of the region (all: 0), and the area inside them: bounded by the line at which the edges of lane
// o.most end, so that another pattern laid up to there leaves no gap and lays nothing twice.  Where a wall has no more
// than o.most lanes on a side, nothing is left.  Parts no larger than what the edge of a bead flows over are left out.
FirstLanes first_lanes(const Loops& region, const LaneOptions& o);

// The rings as curves, in their order.
std::vector<toolpath::Curve> curves_of(const Rings& rings);

// What closed beads lay, mm2; each point has its width.
double laid_area(const toolpath::Curve& bead);
double laid_area(const Rings& rings);

} // namespace filum::rings
