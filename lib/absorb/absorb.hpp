// Void absorption: what beads leave uncovered beside their corners, turns and ends is reached by noses
// (docs/algorithms/fill.md).
#pragma once

#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::absorb {

struct Options {
    double bead_width = 0.4; // mm
};

// The closed `curves` that fill `region`, with points added and widths changed so that they cover more of it.
std::vector<toolpath::Curve> absorb(const polygon::Loops& region, const std::vector<toolpath::Curve>& curves,
                                    const Options& options);

} // namespace filum::absorb
