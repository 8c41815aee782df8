// Areas cut along a straight line parallel to an axis.
#pragma once

#include "polygon/loops.hpp"

#include <optional>
#include <vector>

namespace filum::polygon {

// A line parallel to the y axis (upright) or to the x axis.
struct ClipLine {
    bool upright = false;
    double at = 0; // mm
    [[nodiscard]] double above(Vec2 p) const { return (upright ? p.x : p.y) - at; }
    [[nodiscard]] double along(Vec2 p) const { return upright ? p.y : p.x; }
    [[nodiscard]] Vec2 point(double along) const { return upright ? Vec2{at, along} : Vec2{along, at}; }
};

// The middle between two neighbouring lines of the grid of Boolean results, the one nearest to `at`, so that no vertex
// lies on the cut.
double between_grid_points(double at);

// Where an outline crosses a cut.
struct CutEnd {
    double along = 0;
    std::size_t chain = 0;
    Vec2 inside, outside; // the ends of the crossing edge, on this side of the cut and on the other
};

// The part of an outline on one side of a cut: whole loops, and chains that enter and leave over the cut.
struct CutSide {
    Loops whole;
    std::vector<std::vector<Vec2>> chains;
    std::vector<CutEnd> in, out; // sorted along the cut
};

// One side of the outlines of `area`; `upper` is the side where ClipLine::above is positive.
CutSide side(const Loops& area, const ClipLine& cut, bool upper);

// One side of a simple area as a simple area: between every other pair of crossings, the outline follows the cut.
// Nothing if the order of the crossings shows that the area is not simple.
std::optional<Loops> clipped_simple(const CutSide& side, const ClipLine& cut);

// The part of a simple area within a box, whose sides move by at most a grid step. Linear in the points. Nothing if the
// order of crossings shows that the area is not simple.
std::optional<Loops> clipped_simple(const Loops& area, const Box2& box);

} // namespace filum::polygon
