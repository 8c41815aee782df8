// Rings inside the rims: Geo-FISO and Geo-Contour (sections 3.2.1, 3.2.2).
//
// The text is read as follows:
// - gamma: all rims. Contours are resampled at r_resample before they are compared. Each component of the surface has a
//   graph of its own.
// - "the outermost subcontour": of the contours of the first level that are within 1.5 d of the longest rim, the
//   longest.
// - Minimum spanning tree: edges by weight, then by level and place (Kruskal).
// - "the distance between the curve and the current path stays below t_dist for n_thresh path points": from each of
//   these points to the nearest point of the other contour, in space. The path leaves at the first of them to the point
//   nearest to it, follows the other contour against its own direction up to the point nearest to the last of them, and
//   returns there. Children are tried at every point, by level and place.
// - A contour without such a place begins a stroke of its own, at its point nearest to its parent.
// - Geo-Contour's components are cut where levels cease to rise, or to fall; each part is followed inwards ring by
//   ring. A ring starts where it is nearest to the start of the ring inside it, and the innermost one near the maximum,
//   with all of these distances within t_dist if possible. The path omits n_thresh points before the start of the ring
//   and continues at the start of the next one. If that is farther than t_dist, the path is cut.
// - "the points that lie at the local maximum are computed with special caution for numerical errors": vertices inside
//   the innermost ring with a distance within 0.1 d of the greatest there, at least d / 4 apart, from the one farthest
//   from their centre to the nearest next one; cut where that is farther than t_dist.
// - Contours for rerouting (degree > 2) come last, each closed, by level and place.
#pragma once

#include "baselines/kipping2022/options.hpp"
#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::baselines::kipping2022 {

// One path into all maxima and out again.
surfpath::plan::Plan geo_fiso(const surface::Sheet& sheet, const Options& settled);

// Spirals into the maxima, each up to a last line at its maximum, and the contours between them.
surfpath::plan::Plan geo_contour(const surface::Sheet& sheet, const Options& settled);

} // namespace filum::baselines::kipping2022
