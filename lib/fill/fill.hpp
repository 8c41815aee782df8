// Bead lines that fill one connected region, by the pattern asked for.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"
#include "toolpath/path.hpp"

#include <string>
#include <vector>

namespace filum::fill {

// The names that Options::pattern takes.
inline const std::vector<std::string> kPatterns = {"spiral",        "contour",        "zigzag",
                                                   "spiral+zigzag", "contour+zigzag", "rectilinear"};

struct Options {
    std::string pattern = "spiral";       // one of kPatterns
    std::string method = "cyc";           // of the spiral: cyc, or sun2019 for the paper's own construction
    double bead_width = 0.4;              // mm
    double min_width = 0.1;               // mm: narrower beads of the spiral are reported
    double min_radius = 0;                // mm: the spiral turns no tighter where it has room
    std::vector<double> angles_deg = {0}; // of straight lines from the x axis: layer after layer, over and over
    std::int64_t rings = -1; // along the outline: of contour at most this many, of the hybrids and rectilinear exactly;
                             // -1: the pattern's own number (all, 2, 0)
    double threshold = 1.5;  // sun2019: bead widths within which contours are adjacent
};

// What fills `region`, with the region's own data handed on.  Curves and ties as the pattern's own header says; spiral,
// zigzag and spiral+zigzag give one closed curve.  Throws Error(usage) for a pattern or method that does not exist.
toolpath::RegionPaths fill(const polygon::Region& region, const Options& options, Notes& notes);

} // namespace filum::fill
