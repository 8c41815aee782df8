// Seeded ortho-isogeodesics (section 3.1.3): lines from a seed curve along the slope of the distance.
//
// The text is read as follows:
// - gamma: the sheet's sources, from `geodesic --source-lines` or a plane. If all of them lie in a plane that separates
//   the surface, lines grow on both of its sides, each side separately; the authors' seed curves are rims.
// - Start points: at 0, d, 2 d ... along gamma, ceil(l_arc / d) of them.
// - "the closest points in c_{i+1}": in space, on the isocontours resampled at r_resample and the polylines between
//   these points. If there is none within 2 d_iso, the line ends.
// - "if the spacing between two chosen points exceeds d": their distance in space, by at least 1 %, because rounding
//   would otherwise double lines d apart. One new line per level and pair, from the isocontour's point closest to the
//   middle of both, if that is at least least_spacing away from either.
// - "when the spacing decreases enough, segments are ended": below least_spacing, 0.4 d, the later one of the two. With
//   d / 2 lines would end and begin alternately.
// - The last isocontour may be up to d_iso from the rim; the strip beyond it stays uncovered.
#pragma once

#include "baselines/kipping2022/options.hpp"
#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::baselines::kipping2022 {

surfpath::plan::Plan ortheo(const surface::Sheet& sheet, const Options& settled);

} // namespace filum::baselines::kipping2022
