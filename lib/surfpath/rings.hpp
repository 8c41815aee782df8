// Rings about the sources of a surface: lines of equal distance, made gentle.  Private to lib/surfpath.
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

struct Rings {
    std::vector<Line> lines;          // closed, from the sources inwards
    std::vector<std::uint32_t> level; // per line: 0 for those next to the sources
    std::vector<double> radius;       // per line, mm: of the tightest turn that was asked of it
};

// Lines at (i + 1/2) spacings of exact distance from the sources and all rims, i = 0, 1 ..., moved so that each branch
// closes at its maximum (branches.hpp, told as in levels.hpp), each with its corners rounded to the least radius where
// there is room, and to the greatest that fits elsewhere; what is too small for that is left out.  `ridge`: the path
// will end along the ridge.
// Throws Error(bad_input) if there is neither a source nor a rim.
Rings rings(const surface::Sheet& sheet, const Options& options, bool ridge, Facts& facts, Notes& notes);

} // namespace filum::surfpath
