// Rings inside the rims: Geo-FISO and Geo-Contour (sections 3.2.1, 3.2.2).
//
// Readings taken:
//  - gamma: all rims.  Contours are resampled at r_resample before they are compared.  Each component of the surface
//  has
//    a graph of its own.
//  - "the outermost subcontour": the longest contour of the first level that lies within 1.5 d of the rim that spans
//    most.
//  - minimum spanning tree: edges by weight, then level and place (Kruskal).
//  - "the distance between the curve and the current path stays below t_dist for n_thresh path points": from each of
//    these points to the nearest point of the other contour, in space.  The path leaves at the first of them for the
//    point nearest to it, runs the other contour against its own direction up to the point nearest to the last of
//    them, and comes back there.  Children are tried at every point, by level and place.
//  - a contour that no such place is found for begins a stroke of its own, at its point nearest to its parent.
//  - Geo-Contour's components are cut where levels cease to rise, or to fall: what is left runs inwards ring by ring.
//    A ring begins where it is nearest to the beginning of the one inside, the innermost one near the maximum, but so
//    that all of these are within t_dist if it can be; it leaves out n_thresh points before its beginning, and the path
//    goes on to the next one's.  Where that is farther than t_dist, it is cut.
//  - "the points that lie at the local maximum are computed with special caution for numerical errors": vertices inside
//    the innermost ring whose distance is within 0.1 d of the greatest there, d / 4 apart at least, from the one
//    farthest from their middle to the nearest next one; cut where that is farther than t_dist.
//  - rerouting contours (degree > 2) come last, each closed, by level and place.
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
