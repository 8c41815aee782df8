// Curves as they are printed: cut open, reversed, and thinned beside a lane that runs between their passes.
#pragma once

#include "geom/polyline.hpp"
#include "link3d/segment_index.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::link3d {

using geom::length;

inline constexpr double kSamePoint = 1e-6; // mm; points closer than this count as one

// An open bead line.
struct Bead {
    std::vector<Vec2> points;
    std::vector<double> width; // mm, per point, or one for all
};

// Mean of the widths that the curve lists, mm; not weighted by length.
double mean_width(const toolpath::Curve& curve);

// The point `l` mm after `place` along the curve. It stops at the end of an open curve, and after one round of a closed
// one.
Vec2 along(const toolpath::Curve& curve, const Place& place, double l);

// The gap between the end of a closed bead and its start, mm: w (1 - pi / 4), at most a tenth of the curve. The two
// rounded bead ends fill it (docs/algorithms/link3d.md#the-construction).
double cut_gap(const toolpath::Curve& curve);

// The closed curve, cut open at `at`: one round in the order of its points, or in reverse order if `against`. It ends
// `gap` mm before its start.
Bead cut(const toolpath::Curve& curve, const Place& at, bool against, double gap);

// The closed curve, cut open at `at` as by cut(), without a gap: it continues over its own beginning for `over` mm.
Bead cut_over(const toolpath::Curve& curve, const Place& at, bool against, double over);

// The open curve, or its reverse if `against`.
Bead run(const toolpath::Curve& curve, bool against);

// mm; a place closer than this to a corner of a curve is moved to the corner.
inline constexpr double kCorner = 0.005;

// Makes p a point of the bead, if the bead passes within `reach` mm of p. p replaces the end of the nearest segment
// that is closer than kCorner, or is as close as the segment. If that is an end of the bead, the bead stays as it is.
// Otherwise p becomes a new point.
void pin(Bead& bead, Vec2 p, double reach);

// Takes `lane_width` * length of `lane` (mm2) from the passes of the bead on both sides of the lane: half from each
// side, or all from one side if the other has no pass. Only passes within `reach` mm give material; their segments are
// split to at most `reach` / 2. No width falls below `least` times its old value; what a point cannot give is taken
// from points further along the bead. Points move away from the lane by half of their loss of width, so that the far
// edge of the bead stays in place. The two ends of the bead and the point at `fixed` do not move. `lines` are the lines
// for which the bead must leave room. Returns the area taken, mm2.
double thin_beside(Bead& bead, std::span<const Vec2> lane, double lane_width, double reach, double least,
                   const SegmentCells& lines, std::optional<Vec2> fixed = std::nullopt);

} // namespace filum::link3d
