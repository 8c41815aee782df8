// Neighbouring stretches of a path: how far apart they lie, and what is laid twice.
#pragma once

#include "metrics/surface/ground.hpp"

#include <span>

namespace filum::metrics::surface {

struct Gap {
    double error = 0;  // spacing / nominal - 1: below 0 too near, above 0 too far
    double length = 0; // mm of path that it stands for
};

// The gap to the nearest neighbour on each side of every sample, where there is one.  Nominal is the mean of both
// beads' widths times `spread`.  A neighbour is where another part of the path crosses the plane upright on the path,
// in the same layer, on the side in question, within 1.5 nominal spacings, on the same skin (normals less than 90
// degrees apart), within 30 degrees of parallel; of the same chain only if at least 3 nominal spacings of fibre lie
// between.  The spacing is the length of the arc that leaves both places along the surface: their straight distance,
// corrected for the angle between the normals.  Samples and neighbours in declared hairpins do not count, nor, without
// `turns`, those in or near turns.
std::vector<Gap> gaps(std::span<const Sample> samples, double spread, bool turns, int threads);

// mm of path that lies within a quarter of a bead's width of an earlier part of the path, in the same layer, on the
// same skin, within 15 degrees of parallel; earlier parts of the same chain count from two widths of fibre on.
double retraced(std::span<const Sample> samples, int threads);

} // namespace filum::metrics::surface
