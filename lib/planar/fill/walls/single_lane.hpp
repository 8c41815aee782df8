// Moves the lanes of thin walls to their middle: one lane, which opens the curve, or both.
#pragma once

#include "fill/walls/wall_graph.hpp"
#include "toolpath/path.hpp"

#include <optional>

namespace filum::fill::walls {

// Opens the curve along one thin wall, so that it passes that wall once. `curve` goes round a region and has two lanes
// in each of its thin `walls`. Of the longest possible wall one lane is removed; the other moves to the middle and
// becomes as wide as the wall. The ends of the open curve lie where the removed lane was; at a tip, one lies at the end
// of the wall.
//
// The wall begins half a bead away from thicker parts and must be at least three beads long. Its lanes must lie within
// rings::kMostOff beads of their expected place. The new line lies between the lanes and is put on the grid. If it
// crosses anything, the wall is skipped.
//
// Returns the index of that wall. If there is none, returns nullopt and leaves the curve as it is. Tie: the lower wall.
std::optional<std::size_t> pass_once(toolpath::Curve& curve, const WallGraph& walls, double width);

// Moves both lanes of each wall to its middle where the half-thickness is below `least` mm. The curve stays closed and
// passes these lines there and back, with beads of half the wall's width. Only the longest such stretch of a wall
// counts. It must be at least 1.5 beads long, its lanes must be found, and the line must cross nothing. Returns these
// lines (RegionPaths::stacked).
std::vector<std::vector<Vec2>> stack_lanes(toolpath::Curve& curve, const WallGraph& walls, double width, double least);

} // namespace filum::fill::walls
