// What a map comes to: the figures of `metrics --map`.
#pragma once

#include "metrics/figures/figures.hpp"
#include "metrics/surface/map.hpp"

namespace filum::metrics::surface {

// Least, most and hundredths of values, each with the place of the extreme; by area.
struct Spread {
    double mean = 0, least = 0, low = 0, median = 0, high = 0, most = 0; // low and high: of the hundredth beyond
    Vec3 least_at{}, most_at{};                                          // of equals the first
};
Spread spread_of(const Map& map, std::span<const double> values, std::span<const double> weight = {});

// Of one ply: how its gaps and overlaps are spread, and how far its beads lie off what is asked.
struct PlySpread {
    double bare = 0, twice = 0, thrice = 0; // shares of its area; what is laid thrice is laid twice, too
    // mm from the nearest bead's edge, of what no bead reaches: quantiles by area, the greatest and its place.
    double gap_median = 0, gap_high = 0, gap_most = 0;
    double gap = 0; // mm: ninety-nine hundredths of the area are at most that far from a bead
    Vec3 gap_at{};
    // Beads over a point beyond the first, of what has any: quantiles by area, the greatest and its place.
    double over_median = 0, over_high = 0, over_most = 0;
    Vec3 over_at{};
    // Degrees off what is asked, by length; `within`: the share within 15 degrees; nan if nothing is asked.
    double off_mean = 0, off_median = 0, off_high = 0, within = 0;
};
PlySpread ply_spread(const Map& map, std::size_t ply);

// Share of the area whose thickness, evened over a bead's width, is within one ply (the thickest) of nominal.
double within_a_ply(const Map& map);

metrics::figures::Figures map_figures(const Map& map);

} // namespace filum::metrics::surface
