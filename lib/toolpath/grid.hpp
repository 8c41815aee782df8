// Lines on the grid of machines, where they cross nothing either.
#pragma once

#include "toolpath/merge.hpp"
#include "toolpath/path.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace filum::toolpath {

// The nearest place that machines are told: whole micrometres.
inline Vec2 on_grid(Vec2 p) { return {std::round(p.x * 1e3) / 1e3, std::round(p.y * 1e3) / 1e3}; }

// Puts the points of the curve on the grid and drops those that fall together with the one before.  A curve that would
// have fewer than three points, or two of an open one, keeps them all.  No features yet.
void put_on_grid(Curve& curve);

// Pairs (i, j), i < j, of segments that cross properly: each goes from one side of the other to the other side.
// Segments are numbered through all curves, a closed curve's last one included.  Ascending.
// cell: mm, about the length of a segment or the space between lines; only the speed depends on it.
std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(const std::vector<Curve>& curves, double cell);

// mm: how far a point may be moved so that nothing crosses: what beads' edges may be off.
inline constexpr double kMostMoved = 0.01;

// Of two segments that cross, moves one end to the nearest place of the grid, at most kMostMoved away, where neither of
// its segments crosses anything, if there is one.  Lines that nearly touch cross when they are put on the grid: there a
// micrometre does.  Points are on the grid, and stay on it; those at `fixed` stay where they are.  cell: as above.
// Returns the pairs that are left.  Ties: offsets by x, then y; the end that
// is nearer to the other segment, then the first.
std::vector<std::pair<std::uint32_t, std::uint32_t>> part_crossings(std::vector<Curve>& curves, double cell,
                                                                    std::optional<Vec2> fixed = std::nullopt);

} // namespace filum::toolpath
