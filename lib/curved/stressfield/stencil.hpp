// The samples that determine the stress at a vertex of a surface, with weights.
#pragma once

#include "stressfield/samples.hpp"
#include "surface/surface.hpp"

namespace filum::stressfield {

using surface::Surface;

inline constexpr std::size_t kGrain = 512; // vertices or samples per task of a thread

// The value at vertex v is the sum of weight[k] times the value of sample[k], for k in [start[v], start[v + 1]); the
// weights sum to 1. Empty: unknown.
struct Stencils {
    std::vector<std::uint32_t> start, sample;
    std::vector<double> weight;
    std::vector<double> gap; // per vertex: mm to the nearest sample or element on the same side; infinite: none near
};

// Unit normals at the vertices: means of the triangles' normals, weighted by area.
std::vector<Vec3> normals(const Surface& s);

// For points without elements. Samples count if they are at most `reach` from the surface (mm; 0: a quarter of the
// distance to the next sample), which excludes the other side of a thin wall; and, where the surface itself comes
// close to itself, if their normal is within 60 degrees of the vertex's. Of the twelve nearest, the corners of the
// Delaunay triangle around the vertex in its tangent plane are weighted linearly, as on faces with these samples as
// nodes; if the vertex is outside of all triangles, all twelve by interpolating moving least squares (Lancaster &
// Salkauskas 1981), linear in the tangent plane. A vertex without a sample within twice the local spacing (to the
// sixth neighbour) gets none.
Stencils in_cloud(const Surface& s, const std::vector<Vec3>& points, double reach, int threads);

// For elements: the element that contains the vertex, otherwise the nearest outer face (or shell) with the orientation
// of the surface, if it is at most `reach` away (mm; 0: half the mean side of its triangle). Elements are divided into
// tetrahedra around their middles, linear in each; faces into triangles over all their nodes. Ties: the first.
Stencils in_mesh(const Surface& s, const Samples& samples, double reach, int threads);

} // namespace filum::stressfield
