// The dual cells of a surface's vertices, on which directions are defined.
#pragma once

#include "surface/surface.hpp"

#include <vector>

namespace filum::surface::directions {

using geom::Vec3;
using surface::kNone;
using surface::Surface;

// The common border of two neighbouring cells, given by an edge.
struct CellBorder {
    std::uint32_t a = 0, b = 0; // a < b
    Vec3 way{};                 // unit, from a to b
    double border = 0;          // mm: length of the border, from the triangles' middles to the edge's middle
    double conductance = 0;     // mean of the opposite cotangents, limited to 0.01 to 100
};

struct Cells {
    std::vector<Vec3> normal;      // unit: mean of the triangles' normals weighted by their angles at the vertex
    std::vector<double> area;      // mm2: a third of every adjacent triangle
    std::vector<CellBorder> sides; // by a, then by b
    double total = 0;              // mm2
    double mean_side = 0;          // mm: mean edge
};

Cells cells(const Surface& s);

// `v`, perpendicular to the unit vector `from`, rotated by the least rotation that takes `from` to `to`.
Vec3 turned(const Vec3& v, const Vec3& from, const Vec3& to);

// A unit vector perpendicular to `n`; always the same for the same n.
Vec3 across(const Vec3& n);

// The weighted percentile: the least value such that values up to it have at least `share` of the total weight; 0
// without weight.
double percentile(std::vector<std::pair<double, double>> value_and_weight, double share);

} // namespace filum::surface::directions
