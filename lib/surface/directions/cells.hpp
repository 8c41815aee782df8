// The vertices of a surface as cells that cover it: where directions are known.
#pragma once

#include "surface/surface.hpp"

#include <vector>

namespace filum::surface::directions {

using geom::Vec3;
using surface::kNone;
using surface::Surface;

// Two neighbouring cells, those of the ends of an edge.
struct Side {
    std::uint32_t a = 0, b = 0; // a < b
    Vec3 way{};                 // unit, from a to b
    double border = 0;          // mm: of the line between the cells, from the middles of triangles to that of the edge
    double conductance = 0;     // mean of the cotangents across, 0.01 to 100
};

struct Cells {
    std::vector<Vec3> normal; // unit: mean of the triangles', by their angles at the vertex
    std::vector<double> area; // mm2: a third of every triangle
    std::vector<Side> sides;  // by a, then by b
    double total = 0;         // mm2
    double mean_side = 0;     // mm, of the edges
};

Cells cells(const Surface& s);

// `v`, which lies in the plane across the unit vector `from`, turned with it by the least rotation to `to`.
Vec3 turned(const Vec3& v, const Vec3& from, const Vec3& to);

// Some unit vector across `n`; the same for the same n.
Vec3 across(const Vec3& n);

// The least value that `share` of the total weight does not exceed; 0 without weight.
double percentile(std::vector<std::pair<double, double>> value_and_weight, double share);

} // namespace filum::surface::directions
