// Painted faces, layer by layer.  Private to lib/app/modifier.
#pragma once

#include "mesh/mesh.hpp"
#include "polygon/loops.hpp"
#include "slice/slice.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::app::modifier {

// What of the faces that look down lies between the plane of each level and that of the level below, seen from below:
// there the layer leans out over the one below.  By the numbers of the levels' layers.
std::vector<polygon::Loops> seen_from_below(const mesh::Mesh& faces, std::span<const filum::slice::Level> levels,
                                            std::span<const std::uint32_t> layer);

// mm2 of the faces that look down.
double area_facing_down(const mesh::Mesh& faces);

} // namespace filum::app::modifier
