// The processing sequence of S. Sun, Y. Yao, Y. Jiang, "A 3D Continuous Path Generation Method and Evaluation for Fused
// Deposition Manufacturing in Tissue Engineering", 2019, section 3.1, exactly as described there, for comparison.
//
// "Starting from the largest area of the first slice, each layer is visited sequentially.  The next connected region is
// selected sequentially by region area, distance and collision detection relationship."  The reading used here: layer
// by layer; first the largest region of the first layer, then always the region of the layer nearest to the one before,
// which on a new layer is the one above it.  Regions at the height of everything printed cannot collide with it, so
// there is nothing to detect.
#pragma once

#include "sequence/order.hpp"

namespace filum::baselines::sun2019 {

// The ids of `regions`, which are sorted by layers and have consecutive ids from 0. Distances are those of the areas
// in top view. Ties: the larger area, then the lower id.
sequence::Order order(std::span<const polygon::Region> regions);

} // namespace filum::baselines::sun2019
