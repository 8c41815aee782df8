// Closed lines made part of the lines beside them without crossings.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::rows {

using geom::Vec2;
using geom::Vec3;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// Square spacings: what shifts that cross waste (splice.hpp), of one left bare, one laid twice.
inline constexpr double kCrossingWastes = 2;

struct Exchanges {
    double spacing = 1; // mm
    double ends = 0;    // mm: how far from the ends of open lines, at least
};

struct Exchanged {
    std::size_t count = 0;
    double waste = 0; // mm2: left bare and laid twice in sum, more than before; less than nothing where tips go
};

// Two lines side by side are both cut, and the ends that face each other joined by turns: of two lines, of which one is
// closed, comes one, and nothing crosses.  Turns are half a spacing wide: half turns from line to line, quarter turns
// where the tip of a loop pointed at the side of a line, next to none where two tips pointed at each other.
//
// Of all such exchanges that make lines part of others those are taken that waste least, mm2 left bare and mm2 laid
// twice, one after the other, given those before (Kruskal 1956); none that wastes as much as shifts that cross
// (splice.hpp).  Lines that are taken in are left empty.  `keep`: per line, those that take in others only, as open
// ones do.  An open line keeps its ends and its sense.  Ties: the first line, the least way.
Exchanged exchange_loops(const Surface& s, std::vector<Line>& lines, std::span<const char> keep,
                         const Exchanges& options);

} // namespace filum::surfpath::rows
