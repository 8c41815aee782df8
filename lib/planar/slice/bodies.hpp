// Turns the contours of one layer into the solid that they bound. Bodies are united, and hairlines between faces that
// should coincide, as rounding and facets leave them, are healed. Private to lib/planar/slice.
#pragma once

#include "base/note.hpp"
#include "mesh/winding.hpp"
#include "polygon/arrange.hpp"

namespace filum::slice {

// Patches that bridge the gaps of at most `width` mm between edges that face each other. They reach a little into the
// solid on both sides. They run counter-clockwise and are meant to be united with `loops`. Returns in `gap_area` the
// area of the gaps, in mm2, and in `gaps` their number. Gaps of at most 1 um come from rounding; they are bridged but
// not counted.
polygon::Loops bridges(const polygon::Loops& loops, double width, double& gap_area, std::size_t& gaps);

// The union of the bodies of a layer. `body` numbers the body of each loop. A body fills the points with a nonzero
// winding number of its loops. If `hollow` is set for it, the number must be positive, so that cavities stay empty.
// Takes about n log n time, even if many bodies lie in one place.
polygon::Loops unite_bodies(const polygon::Loops& loops, const std::vector<std::uint32_t>& body,
                            const std::vector<char>& hollow);

// The part of the plane at height z inside a surface that is not closed. `walls` divide the plane into faces. Walls of
// the surface are marked and have weight 1, others have weight 0. A face is inside if the winding number of the surface
// along its borders exceeds 1/2, averaged over their length.
polygon::Loops solid_within(const std::vector<polygon::Wall>& walls, const mesh::Winding& surface, double z);

// Heals gaps and slivers below `hairline` mm, with notes, and returns the new loops. Slivers are removed if `united`,
// as bodies met there, or if a gap was bridged. Otherwise thin parts stay as they are. Precondition: simple loops.
polygon::Loops heal_hairlines(polygon::Loops loops, bool united, double hairline, std::int64_t layer, Notes& notes);

} // namespace filum::slice
