// Changes the triangles of a surface: remeshing and cutting.
#pragma once

#include "surface/section.hpp"

#include <span>

namespace filum::surface {

// The number of triangles that are so long and thin that remesh() would take more than kMostWork times as long as for
// compact ones; 0 if it would not. The work is estimated by the squared longest sides of triangles longer than `edge`,
// in units of edge^2, since halving long sides makes about as many triangles.
inline constexpr double kMostWork = 10;
std::size_t stretched(const Surface& s, double edge);

// The surface with triangles whose sides are about `edge` mm long; its vertices lie on the given triangles. Rims and
// edges sharper than 30 degrees keep their shape; they get further points, so sides may be shorter there. CGAL
// isotropic_remeshing, after Botsch, Kobbelt 2004, three rounds.
// Throws Error(usage) if it would take more than 20 million triangles, Error(failure) if CGAL fails.
Surface remesh(const Surface& s, double edge, Notes& notes);

// The part of the surface below the plane, dot(normal, p) <= offset. Triangles across the plane are split consistently
// with their neighbours.
// Throws Error(usage) if nothing is left, or if the normal is (0, 0, 0).
Surface cut(const Surface& s, const Plane& plane, Notes& notes);

// The part of the surface where `side`, a linear function given per vertex, is at most 0. Corners where |side| is less
// than a hundredth of its change along an edge move onto the cut, which avoids slivers.
// Throws Error(usage) if nothing is left.
Surface cut(const Surface& s, std::span<const double> side, Notes& notes);

// The part of the surface inside or outside of the closed mesh `solid`; triangles are split along its surface. Parts
// that coincide with it stay in both cases. CGAL clip, by corefinement.
// Throws Error: bad_input if the mesh is open or crosses itself, or if the surface crosses itself where it is cut;
// usage if nothing is left; failure if CGAL fails.
Surface cut(const Surface& s, const mesh::Mesh& solid, bool inside, Notes& notes);

} // namespace filum::surface
