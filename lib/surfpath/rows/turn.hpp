// Turns from the end of a row to that of another, drawn flat.
#pragma once

#include "geom/vec.hpp"

#include <span>
#include <vector>

namespace filum::surfpath::rows {

using geom::Vec2;

// Both rows come from below (y < 0) and end on the line that bounds the turn: the first at the origin, the second to
// the right of it.  Rows are polylines from their ends inwards, the bound one from the first end to the second.
struct TurnRoom {
    std::span<const Vec2> first, second, bound;
    double behind = 0; // mm: how far behind the outermost place the turn is wanted
};

struct FlatTurn {
    std::vector<Vec2> points; // from the first row to the second; empty if there is none
    double radius = 0;        // mm, of its arcs
    double from_first = 0;    // mm along the first row from its end: where the turn begins
    double from_second = 0;   // mm along the second row from its end: where it ends
    double length = 0;        // mm
    bool bulb = false;        // it swings out on both sides of the rows
};

// The outermost turn within the bound, or that far behind it: an arc off the first row, a straight stretch along the
// bound and an arc onto the second row, of `radius`; where rows are nearer to each other than two radii a bulb of that
// radius, and where there is no room for it, or none are wanted, the one arc that fits.  Everything stays below the
// bound.  Smooth with rows that are.
FlatTurn turn(const TurnRoom& room, double radius, bool bulbs = true);

// From p along t on to q, where it comes by u, both unit: as a cubic that is an arc, but for a thousandth, where p and
// q lie on a circle with these tangents.  Points are about `step` mm apart.
std::vector<Vec2> led(Vec2 p, Vec2 t, Vec2 q, Vec2 u, double step);

} // namespace filum::surfpath::rows
