// Maps of a finished toolpath on a surface: thickness, coverage and fibre directions, per point and ply.
#pragma once

#include "metrics/surface/fibres.hpp"
#include "surface/finer.hpp"
#include "surface/sheet.hpp"

#include <span>

namespace filum::metrics::surface {

using filum::surface::Surface;

// The direction that fibres should follow: a direction projected onto the surface and turned, or vectors per vertex.
struct RequestedDirection {
    Vec3 reference{};                             // of any length; (0, 0, 0): none
    double turn = 0;                              // rad, counter-clockwise as seen from the side that the ground faces
    const filum::surface::Field* field = nullptr; // if not null, used instead: per vertex of the ground
};

// A ply: the segments of one layer of the toolpath.
struct Bed {
    std::uint32_t layer = 0;
    Surface ground; // the surface under the ply: the base, offset; turned over for plies on the back of the base
    RequestedDirection asked{};
    std::vector<double> edge{}; // mm per vertex of the base: distance from the ply's edge, negative within; empty:
                                // the ply covers everything
};

// One ply at the points of a Map.
struct PlyMap {
    double width = 0, height = 0; // mm: medians over its beads, by length
    std::vector<double> edge; // mm from the planned edge of the ply, negative within; empty: the ply covers everything
    std::vector<double> inside;    // 0 to 1: fraction of the point's area that is within the edge
    std::vector<double> passes;    // number of beads over it: 0: gap; 2: overlap; fractions at edges of beads
    std::vector<double> amount;    // material per area over the ply's own thickness, within a bead's width of the point
    std::vector<double> deviation; // degrees between the nearest bead and the requested direction; infinite if no bead
                                   // is near, or without a request
    std::vector<double> clearance; // mm from the nearest bead's edge, negative under beads; at most a bead's width
    // Degrees between beads and the requested direction, by their length, turns included, except for beads past the
    // rims or past the edge of the ply.
    std::vector<Weighted> off;
};

struct Map {
    filum::surface::FinerSurface ground; // the base in triangles with sides of at most a third of the narrowest bead
    std::vector<double> area;            // mm2, per vertex
    std::vector<PlyMap> plies;           // in the order of the beds
    std::vector<double> nominal;         // mm: the sum of heights of the plies that are planned at the point
    std::vector<double> thickness;       // mm: the sum of passes times heights
    std::vector<double> even; // mm: the sum of amounts times heights: the thickness if beads spread by their width
};

// The map of the fibres on `base`; the grounds of `beds` have its triangles. The result does not depend on `threads`.
Map map(const Surface& base, const Fibres& fibres, std::span<const Bed> beds, int threads);

// One bed per layer of the fibres, from the lowest: the base offset at each vertex to the middle of the fibres; turned
// over if the tool is on its back.
std::vector<Bed> beds(const Surface& base, const Fibres& fibres, int threads);

// The finite ones of `values` at the points, by area; only where `weight` (0 to 1) is above 0.
std::vector<Weighted> weighed(std::span<const double> values, std::span<const double> area,
                              std::span<const double> weight = {});

// The fraction of the ply's planned area, 0 to 1, with more than `more` beads; linear up to one bead more.
double share_beyond(const PlyMap& ply, std::span<const double> area, double more);

} // namespace filum::metrics::surface
