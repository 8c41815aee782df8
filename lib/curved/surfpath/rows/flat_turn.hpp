// Turns from the end of a row to that of another, in the plane.
#pragma once

#include "geom/vec.hpp"

#include <span>
#include <vector>

namespace filum::surfpath::rows {

using geom::Vec2;

// The surroundings of a turn. Both rows come from below (y < 0) and end on the bound: the first at the origin, the
// second to the right of it. Rows are polylines from their ends inwards; the bound leads from the first end to the
// second.
struct TurnRoom {
    std::span<const Vec2> first, second, bound;
    double behind = 0; // mm from the bound to the outermost place of the turn
};

struct FlatTurn {
    std::vector<Vec2> points; // from the first row to the second; empty if there is no turn
    double radius = 0;        // mm, of its arcs
    double from_first = 0;    // mm along the first row from its end to the start of the turn
    double from_second = 0;   // mm along the second row from its end to the end of the turn
    double length = 0;        // mm
    bool bulb = false;        // it bulges to both sides of the rows
};

// The outermost turn within the bound, or `behind` mm inside of it. Usually an arc of `radius`, a straight line along
// the bound, and another arc. If the rows are nearer than two radii it is a bulb of that radius; without room for a
// bulb, or if `bulbs` is false, the one arc that fits. Its tangents are those of the rows.
FlatTurn turn(const TurnRoom& room, double radius, bool bulbs = true);

} // namespace filum::surfpath::rows
