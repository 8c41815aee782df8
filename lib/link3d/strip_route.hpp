// Ways through a filled region that cross no bead.
//
// The lanes of a curve that does not cross itself leave strips between them, about one bead wide, and the strips on
// either side of the curve are connected.  So a nozzle can get from one place of the curve to any other along the
// middle of a strip, without crossing anything.
#pragma once

#include "link3d/segment_index.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace filum::link3d {

// The shortest way from `from`, a point of `lines`, along the middle of the strips between the lines of a region to the
// first place at which `arrived`; the first point is `from`.  Each step halves a triangle of the constrained Delaunay
// triangulation of `lines`, from the middle of one side to the middle of another, so it crosses no line.  Strips that
// are narrower than 0.5 or wider than 1.3 `width` (mm) are not used: the wide ones are holes and the outside of the
// part. Nothing if there is no such way of at most `limit` mm.  Tie: by the order of the triangulation, which is that
// of the points.  `index` holds `lines`.  Cost: near-linear in the number of points.
std::optional<std::vector<Vec2>> strip_route(std::span<const std::vector<Vec2>> lines, const SegmentIndex& index,
                                             Vec2 from, double width, double limit,
                                             const std::function<bool(Vec2)>& arrived);

} // namespace filum::link3d
