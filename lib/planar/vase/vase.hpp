// Turns the regions of a part into those of a vase: a floor, then one outline per layer (docs/algorithms/vase.md).
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "polygon/region.hpp"

#include <cstdint>
#include <vector>

namespace filum::vase {

struct Options {
    double bead_width = 0.4; // mm
    std::int64_t bottom = 4; // layers of the floor, >= 0
    std::int64_t walls = 1;  // beads side by side above the floor, >= 1
};

// Turns the regions of a part, in the order of their layers, into those of a vase, and returns them. Every outline of
// the first layer starts a vase. A vase continues while exactly one outline of the next layer lies over it and over no
// other vase. So it ends below a branch.
//
// The first `bottom` layers are the floor of a vase. The floor is solid, except for holes that go through all layers
// from the first one on. Above it, a region is its outer outline with `walls` beads, and is empty inside.
//
// Notes report material left out above a branch or inside outlines, and walls without support. Facts: `vase-turns`.
// Throws Error(bad_input) if no vase is higher than its floor.
std::vector<polygon::Region> vase(const std::vector<polygon::Region>& part, const Options& options, Notes& notes,
                                  Facts& facts);

} // namespace filum::vase
