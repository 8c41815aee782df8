// Statistics of a map: the figures of `metrics --map`.
#pragma once

#include "figures/figures.hpp"
#include "metrics/surface/map.hpp"

namespace filum::metrics::surface {

// Extremes with their places, and quantiles; by area.
struct Spread {
    double mean = 0, least = 0, low = 0, median = 0, high = 0, most = 0; // low, high: quantiles of 1 and 99 %
    Vec3 least_at{}, most_at{};                                          // ties: the lowest vertex
};
Spread spread_of(const Map& map, std::span<const double> values, std::span<const double> weight = {});

// Statistics of one ply: gaps, overlaps and deviations from the requested direction.
struct PlySpread {
    double bare = 0, twice = 0, thrice = 0; // fractions of its area under no, two or more, three or more beads
    // mm from the nearest bead's edge, over the uncovered area: quantiles by area, the greatest value and its place.
    double gap_median = 0, gap_high = 0, gap_most = 0;
    double gap = 0; // mm: 99 % of the area is at most that far from a bead
    Vec3 gap_at{};
    // Number of beads above one, over the area with overlaps: quantiles by area, the greatest value and its place.
    double over_median = 0, over_high = 0, over_most = 0;
    Vec3 over_at{};
    // Degrees from the requested direction, by length; `within`: fraction within 15 degrees; nan without a request.
    double off_mean = 0, off_median = 0, off_high = 0, within = 0;
};
PlySpread ply_spread(const Map& map, std::size_t ply);

// Fraction of the area whose thickness, averaged over a bead's width, is within one ply (the thickest) of nominal.
double within_a_ply(const Map& map);

figures::Figures map_figures(const Map& map);

} // namespace filum::metrics::surface
