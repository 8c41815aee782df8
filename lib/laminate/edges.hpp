// Where plies of a laminate lie: their edges on the surface, and the ramps on which those above step down.
#pragma once

#include "base/note.hpp"
#include "laminate/stack.hpp"
#include "surface/sheet.hpp"

namespace filum::laminate {

using geom::Vec3;
using surface::Surface;

// The base surface of plies, in triangles as fine as their spacing.
struct Base {
    Surface surface;
    std::vector<std::uint32_t> faces; // per triangle, the CAD face; none: not known
};

// mm from a ply's edge per vertex, below 0 where the ply lies; empty: it lies everywhere.
using Edge = std::vector<double>;

// The edge of what `within` says.  Curves are drawn onto the surface and closed; the ply lies to their left, seen from
// the side that the surface faces.  Where they run nearer than `near` mm to a rim, that is the ply's end, and no edge.
// Notes curves that lie farther off the surface than that.
// Throws Error(bad_input) if curves end at a rim or do not part the surface, and if there are no such faces.
Edge edge_of(const Base& base, const Within& within, double near, Notes& notes);

// What lies below each ply on its side at every vertex, mm: heights of the plies that lie there; beside their edges
// these go down to 0 over `ratio` mm per mm of height, or over their spacing if that is more.
std::vector<std::vector<double>> heights_below(std::span<const Ply> plies, std::span<const Edge> edges,
                                               std::size_t vertices, double ratio);

// Moves edges apart, so that no ply ends nearer than `ratio` times its height to the edge of another one on its side:
// of two that lie within each other the smaller one ends farther within; of two as large, which are within each other,
// the upper one.  Notes what was moved, by how much at most, and where edges that cross stay too near each other.
// Throws Error(failure) naming the ply of which nothing is left.
void make_ramps(const Surface& s, std::span<const Ply> plies, double ratio, std::vector<Edge>& edges, Notes& notes);

} // namespace filum::laminate
