// Rings around the sources of a surface: lines of equal distance with rounded corners.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "surface/sheet.hpp"
#include "surfpath/rings/ring.hpp"

namespace filum::surfpath::rings {

struct Rings {
    std::vector<Line> lines;          // closed, from the sources inwards
    std::vector<std::uint32_t> level; // per line: number of rings outside of it
    std::vector<double> radius;       // per line, mm: radius by which its corners are rounded
};

struct RingLimits {
    double spacing = 1;        // mm
    double least_radius = 2.4; // mm: where there is room
    bool ridge = false;        // whether the path will end along the ridge
};

// Lines at (i + 1/2) spacings of exact distance from the sources and all rims, i = 0, 1, ..., shifted so that each
// branch closes at its maximum (branches.hpp; facts and notes as in levels.hpp). Corners are rounded to the least
// radius where there is room, and to the greatest radius that fits elsewhere; lines too small for that are left out.
// Throws Error(bad_input) if there is no room for a ring, Error(usage) if there would be more than 10000 levels.
Rings rings(const surface::Sheet& sheet, const RingLimits& limits, Facts& facts, Notes& notes);

} // namespace filum::surfpath::rings
