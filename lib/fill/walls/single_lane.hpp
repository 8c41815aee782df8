// Lanes of thin walls moved to their middle: one of them, which opens the curve, or both.
#pragma once

#include "fill/walls/wall_graph.hpp"
#include "toolpath/path.hpp"

#include <optional>

namespace filum::fill::walls {

// `curve` goes round a region and runs along each of its thin `walls` there and back, in two lanes.  Takes one lane of
// the longest wall out, moves the other one to its middle and makes it as wide as the wall: the curve is open then, its
// ends lie where that lane was, at a tip one of them at its end.  A wall counts from where it is half a bead away from
// thicker parts, and must be at least three beads long; its lanes must be found within a fifth of a bead of where they
// should be.  The new line lies between the lanes and is put on the grid; where it would cross anything all the same,
// the wall does not count.
//
// Returns that wall; nothing, and leaves the curve as it is, if there is no such wall.  Tie: the lower wall.
std::optional<std::size_t> pass_once(toolpath::Curve& curve, const WallGraph& walls, double width);

// Moves both lanes of every wall, where its half-thickness is below `least`, to its middle: the curve stays closed and
// passes these lines there and back, with beads of half the wall's width.  Of each wall the longest such stretch
// counts, if it is at least a bead and a half long, its lanes are found, and the line crosses nothing.  Returns those
// lines (RegionPaths::stacked).
std::vector<std::vector<Vec2>> stack_lanes(toolpath::Curve& curve, const WallGraph& walls, double width, double least);

} // namespace filum::fill::walls
