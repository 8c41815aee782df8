// A mesh to closed contours per layer.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"
#include "polygon/region.hpp"

#include <vector>

namespace filum::slice {

struct Options {
    double layer_height = 0.2; // mm
};

// The layers of `mesh`, lowest first, cut at mid-height.
std::vector<polygon::Layer> slice(const mesh::Mesh& mesh, const Options& options, Notes& notes);

} // namespace filum::slice
