// Rings about the sources of a surface: lines of equal distance, made gentle.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "surface/sheet.hpp"
#include "surfpath/rings/ring.hpp"

namespace filum::surfpath::rings {

struct Rings {
    std::vector<Line> lines;          // closed, from the sources inwards
    std::vector<std::uint32_t> level; // per line: 0 for those next to the sources
    std::vector<double> radius;       // per line, mm: of the tightest turn that was asked of it
};

struct RingLimits {
    double spacing = 1;        // mm
    double least_radius = 2.4; // mm: of rings, where there is room
    bool ridge = false;        // the path will end along the ridge
};

// Lines at (i + 1/2) spacings of exact distance from the sources and all rims, i = 0, 1 ..., moved so that each branch
// closes at its maximum (branches.hpp, told as in levels.hpp), each with its corners rounded to the least radius where
// there is room, and to the greatest that fits elsewhere; what is too small for that is left out.
// Throws Error(bad_input) if there is neither a source nor a rim.
Rings rings(const surface::Sheet& sheet, const RingLimits& limits, Facts& facts, Notes& notes);

} // namespace filum::surfpath::rings
