// The plane cut up by line segments that may cross, overlap, lie on each other or hang loose: its faces, and how often
// each is wound round.
//
// Exact: on the grid of 0.1 um, with whole numbers.  Segments are parted where they meet, crossings rounded to the
// grid, until no two have a point in common but their ends (iterated snap rounding: Halperin and Packer 2002); a sweep
// then tells the faces.  Copies of a segment cost no more than one.
#pragma once

#include "polygon/clip.hpp"

#include <functional>
#include <optional>

namespace filum::polygon {

// A segment and how it counts: `weight` times from a to b (0: it parts faces, and winds round nothing).
struct Wall {
    Vec2 a, b;
    int weight = 1;
    bool marked = false; // by the caller; what lies on a marked one is marked
};

// A piece of a wall between two faces; `left` as seen from a to b.  Both may be the same face.
struct Border {
    Vec2 a, b;
    std::uint32_t left = 0, right = 0;
    int weight = 0; // of all walls there, from a to b
    bool marked = false;
};

struct Arrangement {
    std::vector<Border> borders; // by a, then b; a has the lesser x, or y if those are equal
    std::vector<int> winding;    // per face: how often the walls run round it counter-clockwise; face 0 is outside all
};

// n log n in the walls and their crossings.  Nothing if rounding does not come to an end, which no input is known to
// do.  Precondition: coordinates within 1e8 mm.
std::optional<Arrangement> arrange(const std::vector<Wall>& walls);

// The outlines of the faces for which solid(face) is true, as simple loops: outer ones counter-clockwise, holes
// clockwise; they may touch in single points.  Points between two borders in a straight line are left out.
Loops outline(const Arrangement& plane, const std::function<bool(std::uint32_t)>& solid);

// The edges of `loops`, each counting once.
std::vector<Wall> walls(const Loops& loops);

// The area that the loops wind round, by `rule`: what clip.hpp's unite does, for any input as fast.
Loops unite_exactly(const Loops& loops, Fill rule = Fill::nonzero);

} // namespace filum::polygon
