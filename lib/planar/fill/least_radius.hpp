// Paths with a minimum radius, for material that cannot bend sharply, such as fibres.
#pragma once

#include "base/note.hpp"
#include "fill/rings/rings.hpp"
#include "toolpath/path.hpp"

#include <cstddef>

namespace filum::fill {

// Rounds the lanes of a region: removes the corners and specks that a disc of `radius` does not reach. Corners become
// arcs of that radius, and small rings disappear. Three things stay: arms too narrow for the disc, parts that rounding
// would split, and parts of the first lane that would vanish.
//
// Inner lanes keep `width` / 2 away from the outer ones. Each point gets the width of the nearest point of its original
// lane. `open` is increased by the area in mm2 that the lanes lose, and gets the place of the largest loss.
rings::Rings with_round_corners(const rings::Rings& lanes, double width, double tolerance, double radius, Note& open);

// The radius to draw an arc with, so that it measures `radius`. Its points are `scale` mm apart and up to `off` mm off
// the arc.
double drawn_radius(double radius, double scale, double off);

// Counts the places where closed curves turn tighter than `radius` mm, measured by toolpath::radius_at as in `metrics`.
// Tight vertices within 2 `scale` of each other along the curve count as one place. The note gives the tightest place.
Note tight_turns(const std::vector<toolpath::Curve>& curves, double scale, double radius);

} // namespace filum::fill
