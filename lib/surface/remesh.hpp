// Changing the triangles of a surface.
#pragma once

#include "surface/section.hpp"

#include <span>

namespace filum::surface {

// How many triangles are so long and thin that remesh() would take more than kMostWork times as long as for squarish
// ones; 0 if it would not.  The squared longest sides of those that are longer than `edge` stand for the work: halving
// long sides makes about as many triangles of them, in squares of `edge`.
inline constexpr double kMostWork = 10;
std::size_t stretched(const Surface& s, double edge);

// The surface in triangles whose sides are about `edge` mm, its vertices on the old triangles.  Rims and edges sharper
// than 30 degrees are kept as they are, but for points in between: there sides may be shorter.
// Throws Error(usage) if it would take more than 20 million triangles, Error(failure) if CGAL cannot do it.
// (CGAL isotropic_remeshing, after Botsch, Kobbelt 2004; three rounds.)
Surface remesh(const Surface& s, double edge, Notes& notes);

// The part of the surface on the plane's lower side, dot(normal, p) <= offset: triangles across it are split, in
// places where the neighbours are, too.
// Throws Error(usage) if nothing is left, or the normal has no length.
Surface cut(const Surface& s, const Plane& plane, Notes& notes);

// Likewise the part where `side`, a number per vertex and linear between them, is at most 0.  Corners where it is
// nearer to 0 than a hundredth of what it changes along a side move there, so that no sliver is cut off. Throws
// Error(usage) if nothing is left.
Surface cut(const Surface& s, std::span<const double> side, Notes& notes);

// The part of the surface inside the closed mesh `solid`, or that outside; triangles are split along its surface.  What
// lies on it stays either way.
// Throws Error: bad_input if the mesh is open or crosses itself, or the surface does where it is cut; usage if nothing
// is left; failure if CGAL cannot do it.  (CGAL clip, by corefinement.)
Surface cut(const Surface& s, const mesh::Mesh& solid, bool inside, Notes& notes);

} // namespace filum::surface
