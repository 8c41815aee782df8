// Joins closed lines to neighbouring lines without crossings.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::rows {

using geom::Vec2;
using geom::Vec3;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// Square spacings of void and overlap that a pair of crossing shifts (splice.hpp) wastes: one of each.
inline constexpr double kCrossingWastes = 2;

struct ExchangeOptions {
    double spacing = 1; // mm
    double ends = 0;    // mm: least distance from the ends of open lines
    // mm: what turns tighter than this counts as waste, too, a spacing wide; 0: nothing does
    double radius = 0;
};

struct ExchangeResult {
    std::size_t count = 0;
    double waste = 0; // mm2: additional void, overlap and tight turns; may be negative where tips disappear
};

// An exchange cuts two lines side by side open and connects the ends that face each other by turns, which makes one
// line of two without a crossing. At least one of them is closed. Turns are half a spacing wide: half turns between
// parallel lines, quarter turns where the tip of a loop points at the side of a line, almost none where two tips point
// at each other.
// Of all exchanges that join different lines the one that wastes least (mm2 of additional void and overlap) is made
// first, then the next, given those before, as in Kruskal 1956. None is made that wastes as much as a pair of crossing
// shifts (splice.hpp). Lines that are taken in become empty. `keep`: per line, whether it only takes in others, as
// open lines do. An open line keeps its ends and its direction. Ties: the first line, the least arc length.
ExchangeResult exchange_loops(const Surface& s, std::vector<Line>& lines, std::span<const char> keep,
                              const ExchangeOptions& options);

} // namespace filum::surfpath::rows
