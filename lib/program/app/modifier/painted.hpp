// The areas of painted faces, layer by layer.  Private to lib/program/app/modifier.
#pragma once

#include "mesh/mesh.hpp"
#include "polygon/loops.hpp"
#include "slice/slice.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::app::modifier {

// The parts of the downward faces between the plane of each level and that of the level below, projected along z. There
// the layer overhangs the one below.  `layer`: the layer number of each level; the result is indexed by layer number.
std::vector<polygon::Loops> seen_from_below(const mesh::Mesh& faces, std::span<const filum::slice::Level> levels,
                                            std::span<const std::uint32_t> layer);

// The area of the downward faces, mm2.
double area_facing_down(const mesh::Mesh& faces);

} // namespace filum::app::modifier
