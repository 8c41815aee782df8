// How good distances are: what can be told from the distances alone.
#pragma once

#include "base/fact.hpp"
#include "geodesic/sources.hpp"

#include <span>

namespace filum::geodesic {

// The slope of a distance is 1.  Here: how far that of the values, taken as linear in every triangle, is from it.  Even
// exact values are off by the length of an edge over the distance to the source, and along lines where fronts meet.
struct SlopeError {
    static constexpr double kBounds[] = {0.001, 0.003, 0.01, 0.03, 0.1, 0.3};
    double share[7] = {}; // of the area, with an error in [0, bounds[0]), [bounds[0], bounds[1]) ...
    double mean = 0;      // weighted by area
    double p99 = 0;       // 99 % of the area have no greater one
    double area = 0;      // mm2 of the triangles whose three values are finite
};
SlopeError slope_error(const Surface& surface, std::span<const double> distance);

// By how much any two neighbours differ by more than the edge between them is long, mm: 0 for exact values.
double excess(const Surface& surface, std::span<const double> distance);

// Distances beside exact ones, where those are known.
struct DistanceError {
    std::size_t vertices = 0;              // compared: those farther than a fiftieth of the farthest that is known
    double known = 0;                      // mm: up to where
    double mean = 0, p99 = 0, largest = 0; // of the exact distance
};

// `truth` is infinite where it is not known.
DistanceError distance_error(std::span<const double> truth, std::span<const double> distance);

// These as facts: "reached", "unreached", "farthest-vertex", "excess", "slope-error-mean", "slope-error-p99",
// "slope-error-below-0.01" ...
Facts certificate(const Surface& surface, std::span<const double> distance);

} // namespace filum::geodesic
