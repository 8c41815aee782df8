// One spiral of lines along the boundary of a surface (Geo-Contour of Kipping et al. 2022, made one path).
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// One stroke per component: rings along the sources and all rims, exact geodesic distance apart, run into each other as
// a spiral from the boundary to a ridge or a hole, and joined to it by change-overs where the surface branches. Corners
// keep to the least radius but where a tighter one gains much length: those are declared hairpins.
// Errors: bad_input for a surface too narrow or too coarse for a ring; usage for a spacing below a ten-thousandth of
// the distance to the farthest place.  Notes: NoteCode::ring_unjoined.
Plan geo_contour(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
