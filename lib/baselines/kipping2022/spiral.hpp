// A spiral around a seed point: Geo-Spiral (section 3.2.3).
//
// Readings taken:
//  - "only the c_i up to the first i are kept" for which there are several pieces: that one is not laid, nor what is
//    beyond; their length is noted.
//  - "reindexed to have their starting point with minimal distance to the boundary": to the vertices of the rims, in
//    space; without a rim, nearest to where the contour before begins.
//  - closed contours run one way, from their start all round but for n_thresh points, then straight on to the next
//  one's
//    start; after open ones they begin nearest to where the path is.  An open one begins at the end nearer to where the
//    path is, the next ones opposite in turn: connections are straight, however long, as those of rows are.
//  - "until no further connections can be made": up to the first level of several pieces, or the last.
#pragma once

#include "baselines/kipping2022/options.hpp"
#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::baselines::kipping2022 {

surfpath::plan::Plan geo_spiral(const surface::Sheet& sheet, const Options& settled);

} // namespace filum::baselines::kipping2022
