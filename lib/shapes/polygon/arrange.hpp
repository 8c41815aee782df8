// The arrangement of line segments in the plane, which may cross, overlap, coincide or have loose ends: its faces and
// their winding numbers.
//
// Exact: on the grid of 0.1 um, with whole numbers. Segments are split where they meet, with crossings rounded to the
// grid, until no two share a point except their ends (iterated snap rounding: Halperin and Packer 2002). A sweep then
// finds the faces. Copies of a segment cost no more than one.
#pragma once

#include "polygon/clip.hpp"

#include <functional>
#include <optional>

namespace filum::polygon {

// A segment with its weight: it counts `weight` times from a to b. A weight of 0 separates faces and adds nothing to
// the winding numbers.
struct Wall {
    Vec2 a, b;
    int weight = 1;
    bool marked = false; // set by the caller; a border on a marked wall is marked
};

// A piece of a wall between two faces; `left` is the face on the left from a to b. Both faces may be the same.
struct Border {
    Vec2 a, b;
    std::uint32_t left = 0, right = 0;
    int weight = 0; // of all walls there, from a to b
    bool marked = false;
};

struct Arrangement {
    std::vector<Border> borders; // sorted by a, then b; a has the lesser x, or the lesser y if x is equal
    std::vector<int> winding;    // per face: the winding number, counter-clockwise; face 0 is outside all
};

// The arrangement of `walls`. O(n log n) in the walls and their crossings. Nothing if rounding does not end; no such
// input is known. Precondition: coordinates within 1e8 mm.
std::optional<Arrangement> arrange(const std::vector<Wall>& walls);

// The outline of the faces for which solid(face) is true, as simple loops: outer loops counter-clockwise, holes
// clockwise. Loops may touch in single points. Points between two borders in a straight line are left out.
Loops outline(const Arrangement& plane, const std::function<bool(std::uint32_t)>& solid);

// The edges of `loops`, each with weight 1.
std::vector<Wall> walls(const Loops& loops);

// The area that the loops wind round, by `rule`: the result of unite() in clip.hpp, at the same speed for any input.
Loops unite_exactly(const Loops& loops, Fill rule = Fill::nonzero);

} // namespace filum::polygon
