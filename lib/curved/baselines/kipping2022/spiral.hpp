// A spiral around a seed point: Geo-Spiral (section 3.2.3).
//
// The text is read as follows:
// - "only the c_i up to the first i are kept" for which there are several pieces: that level and all further ones are
//   omitted; a note gives their length.
// - "reindexed to have their starting point with minimal distance to the boundary": to the vertices of the rims, in
//   space; without a rim, nearest to the start of the contour before.
// - Closed contours run in one direction, from their start around except for the last n_thresh points, then straight to
//   the start of the next one; after open ones they begin nearest to the current position. An open one begins at the
//   end nearer to the current position, the next ones alternate in direction. Connections are straight and of any
//   length, as those of rows are.
// - "until no further connections can be made": up to the last level before the first one of several pieces.
#pragma once

#include "baselines/kipping2022/options.hpp"
#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::baselines::kipping2022 {

surfpath::plan::Plan geo_spiral(const surface::Sheet& sheet, const Options& settled);

} // namespace filum::baselines::kipping2022
