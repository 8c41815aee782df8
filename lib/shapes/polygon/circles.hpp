// Circles that touch three sites of a Voronoi diagram. Private to lib/shapes/polygon.
#pragma once

#include <cstdint>
#include <optional>

namespace filum::polygon {

// A point with whole coordinates below 2^31. No two points of a diagram are farther apart than 2^30, so that exact
// results fit into 63 bits.
struct SitePoint {
    std::int64_t x = 0, y = 0;
};
struct SiteLine {
    SitePoint from, to;
};

struct SiteCircle {
    double x = 0, y = 0; // its centre
    double right = 0;    // its greatest x
};

// The circle that touches three directed lines and lies right of all of them. If it lies left of all, `right` is its
// least x. Nothing if its numbers may be off by more than `kCirclePlaces`.
std::optional<SiteCircle> touching_circle(const SiteLine& a, const SiteLine& b, const SiteLine& c);

// The circle through p that touches both lines, where p is left of one and right of the other, or on one of them. There
// are two; `farther` selects the one farther along both directions. Nothing if there is none, or if its numbers may be
// off by more than `kCirclePlaces`.
std::optional<SiteCircle> touching_circle(SitePoint p, const SiteLine& one, const SiteLine& two, bool farther);

// The circle through p and q that touches the line, where both are on one side of it. There are two, unless p-q is
// parallel to the line; `left` selects the one whose centre lies farther left of p -> q. Nothing if there is none, or
// if its numbers may be off by more than `kCirclePlaces`.
std::optional<SiteCircle> touching_circle(SitePoint p, SitePoint q, const SiteLine& line, bool left);

// Largest error of each number, in units in the last place of a double. It is half of what Boost.Polygon's sweep allows
// (ULPS in its voronoi_predicates).
inline constexpr double kCirclePlaces = 32;

} // namespace filum::polygon
