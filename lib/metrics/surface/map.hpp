// How thick plies become on a surface, and how their fibres lie: point by point, of the finished toolpath.
#pragma once

#include "metrics/surface/chains.hpp"
#include "surface/finer.hpp"
#include "surface/sheet.hpp"

#include <span>

namespace filum::metrics::surface {

using filum::surface::Surface;

// What fibres are asked to follow: a direction laid onto the surface and turned on it, or vectors per vertex.
struct Asked {
    Vec3 reference{};                             // of any length; (0, 0, 0): none
    double turn = 0;                              // rad, counter-clockwise as seen from the side that the ground faces
    const filum::surface::Field* field = nullptr; // instead, per vertex of the ground
};

// A ply: its stretches are those of a layer of the toolpath.
struct Bed {
    std::uint32_t layer = 0;
    Surface ground; // what it lies on: the base's triangles, raised; turned over of what lies under the base
    Asked asked{};
    std::vector<double> edge{}; // mm from the ply's edge per vertex of the base, below 0 where it is to lie; empty: all
};

// Of one ply, at the points of a Map.
struct PlyMap {
    double width = 0, height = 0;  // mm: medians of its beads, by length
    std::vector<double> edge;      // mm from where the ply is to end, below 0 within; empty: it is to lie everywhere
    std::vector<double> inside;    // 0 to 1: how much of what the point stands for lies within
    std::vector<double> passes;    // beads that lie over it: 0, a gap; 2, an overlap; at edges of beads between
    std::vector<double> amount;    // material per area over the ply's own thickness, within a bead's width of the point
    std::vector<double> deviation; // degrees from the asked direction, of the nearest bead; infinite: none near, or in
                                   // a declared turn, or nothing asked
    std::vector<double> clearance; // mm from the nearest bead's edge, below 0 under one; at most a bead's width
    // How far beads lie off the asked direction, degrees, by their length, but for declared turns and what lies beyond
    // the rims or where the ply is not to be; turns that are none by their radius count.
    std::vector<Weighted> off;
};

struct Map {
    filum::surface::FinerSurface ground; // the base in triangles with sides of at most a third of the narrowest bead
    std::vector<double> area;            // mm2, per vertex
    std::vector<PlyMap> plies;           // as the beds
    std::vector<double> nominal;         // mm: the sum of heights of the plies that are to lie there
    std::vector<double> thickness;       // mm: the sum of passes times heights
    std::vector<double> even;            // mm: likewise of amounts: as thick as if beads flowed by their width
};

// The map of the fibres on `base`, whose triangles the beds' grounds have.  Same result for any `threads`.
Map map(const Surface& base, const Fibres& fibres, std::span<const Bed> beds, int threads);

// A bed per layer of the fibres, from the lowest: the base raised to where their middle is, place by place; turned over
// where the tool comes from its back.
std::vector<Bed> beds(const Surface& base, const Fibres& fibres, int threads);

// Values at the points, by area: those of `values` that are finite, where `weight` (0 to 1) is above 0.
std::vector<Weighted> weighed(std::span<const double> values, std::span<const double> area,
                              std::span<const double> weight = {});

// The part of the area where a ply is to lie, 0 to 1, over which more than `more` beads lie, up to one more.
double share_beyond(const PlyMap& ply, std::span<const double> area, double more);

// The map as a surface with fields: "thickness", "thickness-even", "thickness-nominal" (mm), "fibre-volume" (even over
// nominal, infinite where that is 0), and of every ply "ply-K.thickness" (mm), "ply-K.covered" and
// "ply-K.twice" (0 to 1), "ply-K.gap" (mm from the nearest bead's edge, below 0 under one), "ply-K.deviation" (degrees)
// and, of those that do not lie everywhere, "ply-K.edge" (mm).
filum::surface::Sheet sheet_of(const Map& map, const std::string& name);

} // namespace filum::metrics::surface
