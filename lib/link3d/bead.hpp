// Curves as they are printed: cut open, turned round, thinned beside a lane that is laid between them.
#pragma once

#include "geom/polyline.hpp"
#include "link3d/segment_index.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::link3d {

using geom::length;

inline constexpr double kSamePoint = 1e-6; // mm; points nearer than this are one

// An open bead line.
struct Bead {
    std::vector<Vec2> points;
    std::vector<double> width; // mm, per point, or one for all
};

// Mean width of a curve, mm, by points.
double mean_width(const toolpath::Curve& curve);

// The point `l` mm behind `place` along the curve, not beyond the ends of an open one.
Vec2 along(const toolpath::Curve& curve, const Place& place, double l);

// The gap that a cut leaves between the end of a closed bead and its start: w (1 - pi / 4), so that the two rounded
// bead ends fill it (docs/algorithms/link3d.md#the-construction); at most a tenth of the curve.
double cut_gap(const toolpath::Curve& curve);

// The closed curve cut at `at`: once around from there, along the order of its points or against it, ending `gap` mm
// short of the start.
Bead cut(const toolpath::Curve& curve, const Place& at, bool against, double gap);

// The same, but on over its own beginning by `over` mm.
Bead cut_over(const toolpath::Curve& curve, const Place& at, bool against, double over);

// The open curve, or its reverse.
Bead run(const toolpath::Curve& curve, bool against);

// mm: what is so near to a corner is at the corner.
inline constexpr double kCorner = 0.005;

// Puts p into the bead as a point, where that is at most `reach` mm away: a new one, or in place of a corner that p is
// at, or that is the nearest of the bead to p; ends stay.
void pin(Bead& bead, Vec2 p, double reach);

// Takes `lane_width` * length of `lane` (mm2) from the beads on both sides of the lane, half from each, where one is
// within `reach` mm; segments there are split to at most `reach` / 2.  No point's width falls below `least` times its
// own; what that forbids moves on to the neighbouring points.  The far edge of the bead stays where it was: points move
// away from the lane by half of what their width loses, but for the ends and the one at `fixed`.  Returns the area
// taken, mm2.
double thin_beside(Bead& bead, std::span<const Vec2> lane, double lane_width, double reach, double least,
                   const SegmentIndex& lines, std::optional<Vec2> fixed = std::nullopt);

} // namespace filum::link3d
