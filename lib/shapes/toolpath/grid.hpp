// Rounds lines to the grid of machines without new crossings.
#pragma once

#include "geom/segment_grid.hpp"
#include "toolpath/merge.hpp"
#include "toolpath/path.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace filum::toolpath {

// The nearest place that a program can express: whole micrometres.
inline Vec2 on_grid(Vec2 p) { return {std::round(p.x * 1e3) / 1e3, std::round(p.y * 1e3) / 1e3}; }

// Rounds the points of the curve to the grid and removes those that coincide with the one before. A curve that would
// have fewer than three points (an open one: two) keeps all. Precondition: the curve has no features.
void put_on_grid(Curve& curve);

// The segments of all curves in their order, the last one of a closed curve included.
std::vector<geom::Segment> segments_of(std::span<const Curve> curves);

// Pairs (i, j), i < j, of segments that cross properly: each goes from one side of the other to the other side.
// Segments are numbered as in segments_of(). Ascending. `cell`: mm, about the
// length of a segment or the distance between lines; affects only the speed. `fresh`: per segment; only pairs with a
// fresh segment count, and the cost is small where these are few. Empty: all are.
std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(const std::vector<Curve>& curves, double cell,
                                                                    std::span<const char> fresh = {});

// mm: the greatest displacement of a point that resolves a crossing: an acceptable error of the edges of beads.
inline constexpr double kMostMoved = 0.01;

// Resolves crossings: of two crossing segments one end is moved to the nearest place of the grid, at most kMostMoved
// away, where none of its segments crosses anything, if there is one. Lines that nearly touch cross after rounding to
// the grid, and then a micrometre is enough. Points must be on the grid, and stay on it; points at `fixed` are not
// moved. `cell`, `fresh`: as above. Returns the remaining pairs. Ties: offsets by x, then y; the end that is nearer to
// the other segment, then the first.
std::vector<std::pair<std::uint32_t, std::uint32_t>> part_crossings(std::vector<Curve>& curves, double cell,
                                                                    std::optional<Vec2> fixed = std::nullopt,
                                                                    std::span<const char> fresh = {});

} // namespace filum::toolpath
