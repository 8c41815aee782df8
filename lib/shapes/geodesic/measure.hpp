// `geodesic`: distances from sources, isolines, and measures of their quality.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "geodesic/sources.hpp"
#include "surface/sheet.hpp"

namespace filum::geodesic {

enum class Method : std::uint8_t {
    either, // exact up to 300,000 triangles, or if 8 windows per triangle are enough; otherwise heat
    exact,
    heat,
};

struct Options {
    Method method = Method::either;
    bool paper = false;         // the heat method as in Kipping et al. 2022
    std::vector<double> levels; // mm: levels of isolines
    double spacing = 0;         // mm: further isolines at first, first + spacing, ... up to the farthest place; 0: none
    double first = 0;           // mm; 0: one spacing
    bool with_sides = false;    // distances and levels are negative on the negative side of the sources
};

// Adds the field "distance" to the sheet, replacing an existing one, and its isolines. Returns facts about the result.
// Isolines have smaller (signed) distances on their left.
// Distances by heat are compared with exact ones as far as four million windows reach, or as those that `either`
// tried: facts "heat-checked" (vertices), "heat-checked-to" (mm), "heat-error-mean", "-p99" and "-max" (% of the exact
// distance); a note if p99 is above 5 % or the maximum above 20 %.
// Throws Error(usage) for levels that are too many or not positive, for `paper` without the heat method, and with
// sides for sources that do not separate the surface.
Facts measure(surface::Sheet& sheet, const Sources& sources, const Options& options, Notes& notes);

} // namespace filum::geodesic
