// The edges of plies on the surface, and the ramps on which the plies above descend.
#pragma once

#include "base/note.hpp"
#include "laminate/stack.hpp"
#include "surface/sheet.hpp"

namespace filum::laminate {

using geom::Vec3;
using surface::Surface;

// The base surface of plies, in triangles as small as their spacing.
struct BaseSurface {
    Surface surface;
    std::vector<std::uint32_t> faces; // per triangle its CAD face; empty: unknown
};

// Signed distance from a ply's edge per vertex, mm, negative inside the ply; empty: the ply covers everything.
using Edge = std::vector<double>;

// The edge of the area `within`. Curves are projected onto the surface and closed; the ply is on their left, seen from
// the side that the surface faces. Where they run nearer than `near` mm to a rim, the ply ends at the rim and has no
// edge there. A note gives curves that are farther than that from the surface.
// Throws Error(bad_input) if curves end at a rim or do not separate the surface, or if faces do not exist.
Edge edge_of(const BaseSurface& base, const Area& within, double near, Notes& notes);

// Per ply and vertex the height of the plies below it on its side, mm. Beside the edge of a ply its height falls to 0
// over `ratio` mm per mm of height, or over its spacing if that is more.
std::vector<std::vector<double>> heights_below(std::span<const Ply> plies, std::span<const Edge> edges,
                                               std::size_t vertices, double ratio);

// Moves edges apart so that no ply ends nearer than `ratio` times its height to the edge of another ply on its side.
// If one ply is inside the other, it ends farther inside; of two equally large ones the
// upper one. Notes give the edges that were moved, by how much at most, and where crossing edges remain too near.
// Throws Error(failure), naming the ply, if nothing of a ply is left.
void make_ramps(const Surface& s, std::span<const Ply> plies, double ratio, std::vector<Edge>& edges, Notes& notes);

} // namespace filum::laminate
