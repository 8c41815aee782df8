// Ways through a filled region that cross no bead.
//
// The lanes of a curve that does not cross itself leave strips between them, about one bead wide, and the strips on
// either side of the curve are connected.  So a nozzle can get from one place of the curve to any other along the
// middle of a strip, without crossing anything.
#pragma once

#include "link3d/segment_index.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace filum::link3d {

// Which strips may be used, in bead widths: a way keeps more than `narrow` away from the nearest line and, at its
// turns, at most `beyond` outside the nearest bead.  Wider ones are holes and the outside of the part.
struct Strips {
    double narrow = 0.2, beyond = 0.15;
};

// For lanes; the others are where a lane just fits, or does not: better a thick place than a stop.  The last kind also
// lays them over voids no wider than a bead, which no bead could fill.
inline constexpr std::array kStrips{Strips{}, Strips{0.05, 0.15}, Strips{0.05, 0.3}, Strips{0.0125, 0.3},
                                    Strips{0.0125, 0.5}};

// The way along the first kind of `strips` that has one, from `from`, a point of `lines`, along the middle of the
// strips between the lines of a region to the place of the highest rank above zero, and of those the nearest; the first
// point is `from`.  `rank(place, least)` says how good a place is to end at, at most `best`; it may say zero for
// whatever is below `least`.
//
// Each step halves a triangle of the constrained Delaunay triangulation of `lines`, from the middle of one side to the
// middle of another, so it crosses no line.  Nothing if there is no such way.  Tie: by the order of the triangulation,
// which is that of the points.  `index` holds `curves`, and those the lines; `width` is that of a bead, mm.  Cost:
// near-linear in the points.
std::optional<std::vector<Vec2>> strip_route(std::span<const std::vector<Vec2>> lines,
                                             std::span<const toolpath::Curve> curves, const SegmentIndex& index,
                                             Vec2 from, double width, std::span<const Strips> strips, int best,
                                             const std::function<int(Vec2, int)>& rank);

} // namespace filum::link3d
