// Finds paths through a filled region that cross no bead.
//
// The passes of a curve that does not cross itself leave strips between them, about one bead wide. The strips on either
// side of the curve are connected. So the nozzle can get from one place of the curve to any other along the middle of a
// strip, without crossing anything.
#pragma once

#include "link3d/segment_index.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace filum::link3d {

// Bead widths outside the nearest bead: no point of a path is farther. A wider void is a hole or the outside of the
// part, where something may stand that was printed before.
inline constexpr double kMostVoid = 0.5;

// The strips that a path may use, in bead widths. A path keeps more than `narrow` away from the nearest line. The
// points where it turns are at most `beyond` outside the nearest bead, and those between at most kMostVoid.
struct Strips {
    double narrow = 0.2, beyond = 0.15;
};

// Kinds of strips for lanes, in the order in which they are tried. In the later ones a lane just fits, or does not fit:
// a thick place is better than a stop. The last kind also crosses voids no wider than a bead, which no bead could fill.
inline constexpr std::array kStrips{Strips{}, Strips{0.05, 0.15}, Strips{0.05, 0.3}, Strips{0.0125, 0.3},
                                    Strips{0.0125, kMostVoid}};

// The path from `from`, a point of `lines`, to the best place, along the middle of the strips between the lines of a
// region. It uses the first kind of `strips` that has a path. The best place has the highest rank above zero, and is
// the nearest of those. `rank(place, least)` returns how good a place is as an end, at most `best`. It may return zero
// for any place ranked below `least`.
//
// Each step crosses a triangle of the constrained Delaunay triangulation of `lines`. It leads from the middle of one
// side to the middle of another, so it crosses no line. A step across a void wider than two kMostVoid is refused, for
// both sides can lie in strips while a hole is between them. Nothing if there is no path. The first point of the path
// is `from`. Tie: by the order of the triangulation, which is that of the points. `index` holds `curves`, and these
// hold the lines; `width` is that of a bead, mm. Cost: near-linear in the points.
std::optional<std::vector<Vec2>> strip_route(std::span<const std::vector<Vec2>> lines,
                                             std::span<const toolpath::Curve> curves, const SegmentIndex& index,
                                             Vec2 from, double width, std::span<const Strips> strips, int best,
                                             const std::function<int(Vec2, int)>& rank);

} // namespace filum::link3d
