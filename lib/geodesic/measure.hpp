// The whole job of `geodesic`: distances from sources, isolines, and how good they are.
#pragma once

#include "base/fact.hpp"
#include "geodesic/sources.hpp"
#include "surface/sheet.hpp"

namespace filum::geodesic {

struct Options {
    std::vector<double> levels; // mm: of isolines
    double spacing = 0;         // mm: isolines also at first, first + spacing, ... up to the farthest place; 0: none
    double first = 0;           // mm; 0: one spacing
};

// Appends the field "distance" to the sheet, and its isolines.  Returns what is known of it as facts.
// Throws Error(usage) for levels that are too many or negative.
Facts measure(surface::Sheet& sheet, const Sources& sources, const Options& options);

} // namespace filum::geodesic
