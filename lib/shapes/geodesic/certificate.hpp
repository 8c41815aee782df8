// Error measures for distances that need no reference, and the comparison with a reference.
#pragma once

#include "base/fact.hpp"
#include "geodesic/sources.hpp"

#include <span>

namespace filum::geodesic {

// A distance has slope 1. This measures the deviation of the slope of the piecewise linear interpolant. Even exact
// values deviate, by the ratio of edge length to distance from the source, and along ridges.
struct SlopeError {
    static constexpr double kBounds[] = {0.001, 0.003, 0.01, 0.03, 0.1, 0.3};
    double share[7] = {}; // share of the area with an error in [0, kBounds[0]), [kBounds[0], kBounds[1]), ...
    double mean = 0;      // weighted by area
    double p99 = 0;       // the 99th percentile by area
    double area = 0;      // mm2 of triangles with three finite values
};
SlopeError slope_error(const Surface& surface, std::span<const double> distance);

// The greatest amount by which values of two neighbours differ by more than the length of their edge, mm; 0 for exact
// values.
double excess(const Surface& surface, std::span<const double> distance);

// Relative errors of distances with respect to exact ones.
struct DistanceError {
    std::size_t vertices = 0;              // number compared: vertices farther than 1/50 of the farthest known distance
    double known = 0;                      // mm: the farthest known distance
    double mean = 0, p99 = 0, largest = 0; // relative to the exact distance
};

// `truth` is infinite where the exact distance is unknown.
DistanceError distance_error(std::span<const double> truth, std::span<const double> distance);

// The measures as facts: "reached", "unreached", "farthest-vertex", "excess", "slope-error-mean", "slope-error-p99",
// "slope-error-below-0.01" and so on.
Facts certificate(const Surface& surface, std::span<const double> distance);

} // namespace filum::geodesic
