// Regions as a stack of layers.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"

#include <string>
#include <vector>

namespace filum::polygon {

// Renumbers the layers of regions from 0 on, in their order, so that never more than `most` empty layers follow each
// other: numbers can be indices then, however sparse they were.  Returns the number that each new layer had.
std::vector<std::uint32_t> close_gaps(std::vector<Region>& regions, std::uint32_t most);

// The notes with the numbers that their layers had before close_gaps.
void restore_layers(Notes& notes, std::span<const std::uint32_t> original);

// What is wrong with the order of regions or with what they say of each other, in plain words; empty if nothing is:
// each id occurs once, layers come one after the other, each higher than the one before, a region lies on regions of
// lower layers, and those whose hole or rim it is in are on its own layer.
std::string fault(const std::vector<Region>& regions);

// What is wrong with an area's outline, in plain words; empty if nothing is: its outer loops run counter-clockwise,
// holes clockwise, and none crosses itself or another.  Loops may touch.
std::string fault(const Loops& loops);

} // namespace filum::polygon
