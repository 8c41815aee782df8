// The six algorithms of J. Kipping, Z. Kallai, T. Schueppstuhl, "A Set of Novel Procedures for Carbon Fiber
// Reinforcement on Complex Curved Surfaces Using Multi Axis Additive Manufacturing", Appl. Sci. 12, 5819, 2022,
// section 3, exactly as described there, for comparison. Nothing is improved: the first row is one spacing from the
// seed curve on both sides, rows are joined wherever their ends are, rings leave voids at maxima of the distance, and
// smoothing leaves the surface.
//
// Where the text is not explicit, it is read as follows:
// - phi is the sheet's field "distance", linear in triangles; the authors' own is that of `geodesic --method heat
//   --paper`. Levels are i d, i = 1, 2, ...; gamma itself is not a line of the path.
// - "the path is resampled to obtain an even point distribution and smoothed by a Savitzky-Golay filter": every stroke
//   separately, all coordinates, the ends by the polynomials of the first and last window, which is scipy's default.
//   r_resample, window and degree are not given and are options. Their defaults are d / 4, 5 and 2: of windows 5 to 11
//   and degrees 2 and 3 the choice for which the curvatures of samples like the authors' are nearest to their Table 1.
// - "offsetting the respective boundary point by the travel height along the normal": done by surfpath::plan::spans.
// - For omitted lines and unreached places a note gives the length or area.
// rows.hpp, ortheo.hpp, rings.hpp and spiral.hpp list further readings.
#pragma once

#include "baselines/kipping2022/options.hpp"
#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::baselines::kipping2022 {

// Strokes on the surface, resampled and smoothed: their points may be off it; their triangles are the nearest ones.
// Throws Error(usage) for options that cannot be followed, or if no level is on the surface; Error(bad_input) if the
// sheet lacks what the algorithm needs.
surfpath::plan::Plan plan(const surface::Sheet& sheet, const Options& options);

} // namespace filum::baselines::kipping2022
