// The rings of a region: the interface of this folder for fills.
#pragma once

#include "fill/rings/rings.hpp"
#include "toolpath/path.hpp"

#include <numbers>

namespace filum::fill::rings {

// Widths squared: the void that the round end of a bead leaves in a right-angled corner; smaller voids are not worth a
// detour.
inline constexpr double kLeastVoid = (1 - std::numbers::pi / 4) / 4;

// Share of a small region that voids too small for a detour may leave in total.
inline constexpr double kMostOpen = 1.0 / 100;

// The smallest void that counts in a region of `area` mm2, mm2: what the edge of a bead of `width` mm flows over, or a
// tenth of kMostOpen of the region if that is less.
double least_void(double width, double area);

struct LaneOptions {
    double width = 0.4;      // mm, of beads wherever no other width is needed
    int most = 0;            // number of lanes from the outline; 0: until the region is full
    double tolerance = 0.01; // mm: largest deviation of the edges of beads
};

// Rings along the lanes of the region (outer loop, then holes): closed, without crossings, each point with the width
// of its lane there. They share the region: their beads leave only tips and corners that are smaller than what the
// edge of a bead flows over, and smaller than a thousandth of the region.
Rings lanes(const Loops& region, const LaneOptions& options);

// The first lanes and the area inside of them.
struct FirstLanes {
    Rings lanes;
    std::vector<Loops> rest; // connected parts, each as outer loop and holes, in the order of polygon::split
};

// Lanes 1 to o.most of the region (0: all) and the area inside them. That area is bounded by the line at which lane
// o.most ends, so that another pattern up to there leaves no gap and no overlap. Where a wall has at most o.most
// lanes on each side, nothing is left. Parts that are no larger than what the edge of a bead flows over are left out.
FirstLanes first_lanes(const Loops& region, const LaneOptions& o);

// The rings as curves, in their order.
std::vector<toolpath::Curve> curves_of(const Rings& rings);

// Area of beads, mm2.
double laid_area(const toolpath::Curve& bead);
double laid_area(const Rings& rings);

} // namespace filum::fill::rings
