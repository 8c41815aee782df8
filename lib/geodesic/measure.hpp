// The whole job of `geodesic`: distances from sources, isolines, and how good they are.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "geodesic/sources.hpp"
#include "surface/sheet.hpp"

namespace filum::geodesic {

enum class Method : std::uint8_t {
    either, // exact up to 300,000 triangles, and beyond if 8 windows per triangle are enough; else heat
    exact,
    heat,
};

struct Options {
    Method method = Method::either;
    bool paper = false;         // heat as Kipping et al. 2022 did it
    std::vector<double> levels; // mm: of isolines
    double spacing = 0;         // mm: isolines also at first, first + spacing, ... up to the farthest place; 0: none
    double first = 0;           // mm; 0: one spacing
    bool with_sides = false;    // distances and levels are negative on the negative side of the sources
};

// Puts the field "distance" into the sheet, in place of one it had, and its isolines.  Returns what is known of it as
// facts.  With sides, each isoline still has what is less, now less with its sign, to its left.
// Distances by heat are compared with exact ones as far as windows reach: four million, or those
// that auto tried ("heat-checked" vertices, up to
// "heat-checked-to" mm, "heat-error-mean", "-p99" and "-max" in % of the exact distance); noted if p99 is above 5 %, or
// the greatest above 20 %. Throws Error(usage) for levels that are too many or not positive, for `paper` without the
// heat method, and with sides for sources that do not separate the surface.
Facts measure(surface::Sheet& sheet, const Sources& sources, const Options& options, Notes& notes);

} // namespace filum::geodesic
