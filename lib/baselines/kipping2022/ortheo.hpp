// Seeded ortho-isogeodesics (section 3.1.3): lines from a seed curve along the slope of the distance.
//
// Readings taken:
//  - gamma: the sheet's sources, `geodesic --source-lines` or a plane.  Where all of them lie in a plane that parts the
//    surface, lines grow to both its sides, each by itself; the authors' seed curves are rims.
//  - start points: at 0, d, 2 d ... along gamma, ceil(l_arc / d) of them.
//  - "the closest points in c_{i+1}": in space, on the isocontours resampled at r_resample and the stretches between.
//    None within 2 d_iso: the line ends.
//  - "if the spacing between two chosen points exceeds d": their distance in space, by 1 % and more, or rounding alone
//    would double lines that lie d apart.  One new line a level and pair, from the isocontour's point closest to the
//    middle of both, if that is least_spacing away from either.
//  - "when the spacing decreases enough, segments are ended": below least_spacing, 0.4 d, the later one of the two.  At
//    d / 2 lines would end and begin again in turn.
//  - a last isocontour may be up to d_iso away from the rim; what is beyond stays empty.
#pragma once

#include "baselines/kipping2022/options.hpp"
#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::baselines::kipping2022 {

surfpath::plan::Plan ortheo(const surface::Sheet& sheet, const Options& settled);

} // namespace filum::baselines::kipping2022
