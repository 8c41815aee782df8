// Paths for material that does not bend sharply: fibres.
#pragma once

#include "base/note.hpp"
#include "rings/rings.hpp"
#include "toolpath/path.hpp"

#include <cstddef>

namespace filum::fill {

// The lanes of a region, each rid of the corners and specks that a disc of `radius` does not reach, so that corners
// become arcs of that radius and small rings stay out.  Arms too narrow for the disc stay, and so do parts that would
// fall apart, and those of the first lane that vanish.  Inner lanes keep half a `width` from the outer ones.  Each
// point is as wide as the lane was next to it.  `open`: what the lanes lay less by that, mm2, and where most of it is.
rings::Rings with_round_corners(const rings::Rings& lanes, double width, double tolerance, double radius, Note& open);

// The radius with which an arc must be drawn to measure `radius` by points `scale` apart that are `off` mm off it.
double drawn_radius(double radius, double scale, double off);

// Places where a closed curve turns tighter than `radius` (toolpath::radius_at, as `metrics` has it), counted once for
// all vertices nearer than 2 `scale` along it; the place is the tightest.
Note tight_turns(const std::vector<toolpath::Curve>& curves, double scale, double radius);

} // namespace filum::fill
