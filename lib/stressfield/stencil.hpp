// Which samples speak for a vertex of a surface, and with what weight.
#pragma once

#include "stressfield/samples.hpp"
#include "surface/surface.hpp"

namespace filum::stressfield {

using surface::Surface;

inline constexpr std::size_t kGrain = 512; // vertices or samples of a piece of work

// The value at vertex v is the sum of weight[k] times that of sample[k], for k in [start[v], start[v + 1]); the
// weights sum to 1.  None: nothing is known there.
struct Stencils {
    std::vector<std::uint32_t> start, sample;
    std::vector<double> weight;
    std::vector<double> gap; // per vertex: mm to the nearest sample or element of the same side; infinite: none near
};

// Unit normals of the vertices: the mean of their triangles' by area.
std::vector<Vec3> normals(const Surface& s);

// Of bare points.  Only samples on the surface count: not farther from it than `reach` (mm; 0: a quarter of the
// distance to the next sample), so that the other side of a thin wall does not mix in; and of these, where the surface
// itself comes back near, those whose normal is within 60 degrees of the vertex's.  Of the twelve nearest, the three
// count that are the corners of the Delaunay triangle about the vertex in its tangent plane, linearly, as within the
// faces that such samples are nodes of; where it lies beyond them, all twelve, by interpolating moving least squares
// (Lancaster & Salkauskas 1981), linear in the tangent plane; a vertex farther from its nearest sample than twice the
// spacing there (to the sixth neighbour) has none.
Stencils in_cloud(const Surface& s, const std::vector<Vec3>& points, double reach, int threads);

// Of elements: in the element that the vertex lies in, else on the nearest outer face (or shell) that faces as the
// surface does, if it is not farther than `reach` (mm; 0: half the mean side of its triangle).  Elements are cut into
// tetrahedra about their middles, linear in each; faces into triangles of all their nodes.  The first of equals
// counts.
Stencils in_mesh(const Surface& s, const Samples& samples, double reach, int threads);

} // namespace filum::stressfield
