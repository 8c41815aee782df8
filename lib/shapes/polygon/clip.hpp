// Boolean operations and offsets of planar areas (Clipper, on a grid of 0.1 um).
//
// Every result is simple: outer loops counter-clockwise, holes clockwise, not crossing.  Coordinates may reach 1e8 mm.
#pragma once

#include "polygon/loops.hpp"

#include <vector>

namespace filum::polygon {

// mm; tolerance of arcs along which beads will lie, about the accuracy of a machine.
inline constexpr double kBeadArc = 0.01;

enum class Fill { nonzero, even_odd, positive };

Loops unite(const Loops& a, Fill rule = Fill::nonzero);
Loops unite(const Loops& a, const Loops& b, Fill rule = Fill::nonzero);

// The same as unite(a) for many loops that overlap their neighbours in the list, up to rounding: halves of the list are
// united first, so that no union has many loops over each other.
Loops unite_by_halves(const Loops& a);

Loops intersect(const Loops& a, const Loops& b, Fill rule = Fill::nonzero);
// The same area as intersect(), faster; its loops may touch themselves in single points.
Loops intersect_touching(const Loops& a, const Loops& b, Fill rule = Fill::nonzero);
Loops subtract(const Loops& a, const Loops& b, Fill rule = Fill::nonzero);

// The part of `a` within a box, whose sides move by at most a grid step. Linear in the points of `a` if `a` is simple.
Loops within_box(const Loops& a, const Box2& box);

// `a` grown by `delta` mm (shrunk if negative), with rounded corners; arcs are off by at most `arc_tolerance` mm.
Loops offset(const Loops& a, double delta, double arc_tolerance = 0.002);

// The part of `a` that is at least 2 `radius` wide: the union of all discs of that radius in `a` (opening). Empty if no
// such disc fits.
Loops opened(const Loops& a, double radius, double arc_tolerance = 0.002);

// The part of `a` outside of `b` that is at least 2 `radius` wide: opened(subtract(a, b), radius), up to the tolerance
// of arcs. Faster where outlines of both run along each other, because both are moved apart before they are compared.
Loops opened_difference(const Loops& a, const Loops& b, double radius, double arc_tolerance = 0.002);

// `a` with all gaps narrower than 2 `radius` filled: everything that no disc of that radius outside `a` reaches
// (closing).
Loops closed(const Loops& a, double radius, double arc_tolerance = 0.002);

// Everything within `radius` mm of the open line: a bead with round ends. A line of one point gives a disc.
Loops around(std::span<const Vec2> line, double radius, double arc_tolerance = 0.002);

// The connected parts of a simple area, each with its outer loop first, then its holes. They are sorted by (y, x) of
// the lowest-left vertex of the outer loop, so the order depends only on the area. `parent[i]` is the part whose hole
// holds part i, -1 if none.
struct Parts {
    std::vector<Loops> part;
    std::vector<int> parent;
};
Parts split(const Loops& a);

// Every loop with fewer points, no removed one farther than `tolerance` mm from the result (Douglas-Peucker on the
// closed loop). Loops of fewer than three points vanish. Simplified loops may cross, so use tolerances far below the
// distances that matter.
Loops simplify(const Loops& a, double tolerance);

// Every loop without its first point if that lies on the line between its neighbours, to a grid step. A contour of an
// upright wall begins on an edge of the mesh, at another place in every layer; without that point the layers are equal.
Loops without_flat_starts(const Loops& a);

} // namespace filum::polygon
