// Circles that touch three sites of a Voronoi diagram.  Private to lib/polygon.
#pragma once

#include <cstdint>
#include <optional>

namespace filum::polygon {

// Whole numbers below 2^31, no two farther apart than 2^30: what is worked out exactly fits into 63 bits.
struct SitePoint {
    std::int64_t x = 0, y = 0;
};
struct SiteLine {
    SitePoint from, to;
};

struct SiteCircle {
    double x = 0, y = 0; // its centre
    double right = 0;    // where it ends on the right
};

// The circle that touches three directed lines and lies right of all of them; if left of all, `right` is its left end.
// Nothing if its numbers may be off by more than `kCirclePlaces`.
std::optional<SiteCircle> touching_circle(const SiteLine& a, const SiteLine& b, const SiteLine& c);

// The circle through p that touches both lines, p being left of one and right of the other, or on one of them.  There
// are two: the one farther along both directions if `farther`.  Nothing if there is none, or its numbers may be off by
// more than `kCirclePlaces`.
std::optional<SiteCircle> touching_circle(SitePoint p, const SiteLine& one, const SiteLine& two, bool farther);

// The circle through p and q that touches the line, both being on one side of it.  There are two, unless p-q is
// parallel to the line: the one whose centre lies farther left of the way from p to q if `left`.  Nothing as above.
std::optional<SiteCircle> touching_circle(SitePoint p, SitePoint q, const SiteLine& line, bool left);

// Places of a double, of each number: half of what Boost.Polygon's sweep allows for (ULPS in its voronoi_predicates).
inline constexpr double kCirclePlaces = 32;

} // namespace filum::polygon
