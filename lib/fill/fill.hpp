// Bead lines that fill one connected region, by the pattern asked for.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"
#include "toolpath/path.hpp"

#include <string>

namespace filum::fill {

struct Options {
    std::string pattern = "spiral"; // spiral, contour, zigzag, rectilinear
    std::string method = "cyc";     // of the spiral: cyc, sun2019
    double bead_width = 0.4;        // mm
    double min_width = 0.1;         // mm: narrower beads are reported
    double angle_deg = 0;           // of zigzag and rectilinear lines from the x axis
    std::int64_t rings = 0;         // contour: at most this many (0: all); rectilinear: rings along the outline
    double threshold = 1.5;         // sun2019: adjacency, in bead widths
};

// What fills `region`, with the region's own data handed on.  Ties and errors as the pattern's own header says.
toolpath::RegionPaths fill(const polygon::Region& region, const Options& options, Notes& notes);

} // namespace filum::fill
