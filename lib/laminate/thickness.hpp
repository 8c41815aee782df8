// How thick a laminate becomes, and how its plies' fibres lie: point by point.
#pragma once

#include "surface/finer.hpp"
#include "surfpath/plan.hpp"

#include <span>

namespace filum::laminate {

using geom::Vec3;
using surface::Surface;

// A ply as it was laid.
struct Laid {
    Surface ground;          // what it lies on: the base's triangles, raised
    surfpath::Plan plan;     // on that
    double width = 1;        // mm, of its beads
    double height = 0.2;     // mm
    double turn = 0;         // rad, of its fibres from the reference
    Vec3 reference{1, 0, 0}; // laid onto the ground; where that stands upright on it nothing is asked
};

// Of one ply, at the points of a Map.
struct PlyMap {
    std::vector<double> passes;    // beads that lie over it: 0, a gap; 2, an overlap; at edges of beads between
    std::vector<double> amount;    // material per area over the ply's own thickness, within a bead's width of the point
    std::vector<double> deviation; // degrees from the asked direction, of the nearest bead; infinite: none near, or in
                                   // a declared turn, or nothing asked
    std::vector<double> clearance; // mm from the nearest bead's edge, below 0 under one; at most a bead's width
};

struct Map {
    surface::Finer ground;         // the base in triangles with sides of at most a third of the narrowest bead
    std::vector<double> area;      // mm2, per vertex
    std::vector<PlyMap> plies;     // in the order of laying
    std::vector<double> thickness; // mm: the sum of passes times heights
    std::vector<double> even;      // mm: likewise of amounts: as thick as if beads flowed by their width
};

// The map of `plies`, whose grounds have the triangles of `base`.
Map map(const Surface& base, std::span<const Laid> plies, int threads);

// Shares of the area, or means over it, of values at its points; infinite values do not count.
struct Spread {
    double mean = 0, least = 0, low = 0, median = 0, high = 0, most = 0; // low and high: of the hundredth beyond
};
Spread spread_of(std::span<const double> values, std::span<const double> area);

// How far the beads lie off the asked direction, degrees, by their length, but for declared turns; `within`: the share
// of the length that is at most 15 degrees off (as `metrics` has it): what is more are turns.
struct Deviation {
    Spread off;
    double within = 0;
};
Deviation deviation(const Laid& ply);

} // namespace filum::laminate
