// Regions as a stack of layers.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"

#include <string>
#include <vector>

namespace filum::polygon {

// Renumbers the layers of regions from 0 on, in their order, so that at most `most` empty layers follow each other.
// Layers within the height of a region are not empty.
// Numbers can then be indices, even if they were sparse. Returns the old number of each new layer.
std::vector<std::uint32_t> close_gaps(std::vector<Region>& regions, std::uint32_t most);

// Gives the layers of `notes` the numbers that they had before close_gaps().
void restore_layers(Notes& notes, std::span<const std::uint32_t> original);

// The fault in the order of regions or in their references to each other, in plain words; empty if there is none. Each
// id must occur once. Layers must ascend, each higher than the one before. A region must lie on regions of lower
// layers; its parent and its brim must be on its own layer.
std::string fault(const std::vector<Region>& regions);

// Throws Error(bad_input) if a region is several layers high. `what` says what that makes impossible, as "make a vase".
void refuse_high(const std::vector<Region>& regions, const std::string& what);

// The fault in an area's outline, in plain words; empty if there is none. Outer loops must run counter-clockwise and
// holes clockwise, and none may cross itself or another. Loops may touch.
std::string fault(const Loops& loops);

} // namespace filum::polygon
