// Neighbouring segments of a path: their distance, and the length that overlaps earlier path.
#pragma once

#include "metrics/surface/ground.hpp"

#include <span>

namespace filum::metrics::surface {

struct Gap {
    double error = 0;  // spacing / nominal - 1: negative if too close, positive if too far
    double length = 0; // mm of path for which it is representative
};

// The gap to the nearest neighbour on each side of every sample that has one. The nominal spacing is the mean of both
// beads' widths times `spread`. A neighbour is a crossing of another part of the path with the plane perpendicular to
// the path, in the same layer, on the side in question, within 1.5 nominal spacings, on the same side of a wall
// (normals less than 90 degrees apart), within 30 degrees of parallel; on the same chain only if at least 3 nominal
// spacings of fibre are between. The spacing is the length of the arc along the surface between both places: their
// straight distance, corrected for the angle between the normals. Samples and neighbours in hairpins do not
// count; without `turns`, those in or near turns do not count either.
std::vector<Gap> gaps(std::span<const Sample> samples, double spread, bool turns, int threads);

// mm of path within a quarter of a bead's width of an earlier part of the path, in the same layer, on the same side of
// a wall, within 15 degrees of parallel; earlier parts of the same chain count if at least two widths of fibre are
// between.
double retraced(std::span<const Sample> samples, int threads);

} // namespace filum::metrics::surface
