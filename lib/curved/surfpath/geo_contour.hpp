// One spiral of lines along the boundary of a surface (Geo-Contour of Kipping et al. 2022, joined into one path).
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// One stroke per component: rings along the sources and all rims at equal geodesic distances. Rings are connected into
// a spiral from the boundary to a ridge or a hole; branches of the surface are joined to it by exchanges. Corners keep
// the least radius unless a tighter one covers much more; those are marked as hairpins.
// Throws Error(bad_input) for a surface that is too narrow or too coarse for a ring, Error(usage) for a spacing below
// a ten-thousandth of the greatest distance. Notes: NoteCode::ring_unjoined.
Plan geo_contour(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
