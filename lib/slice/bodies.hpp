// The contours of one layer to the solid that they bound: bodies become one, without the hairlines that rounding and
// facets leave between faces that should be one; private to lib/slice.
#pragma once

#include "base/note.hpp"
#include "mesh/winding.hpp"
#include "polygon/arrange.hpp"

namespace filum::slice {

// Patches that bridge every gap of at most `width` mm between two edges that face each other across it, reaching a
// little into the solid on both sides; counter-clockwise, to be united with `loops`.  `gap_area` gets the area of the
// gaps, mm2, `gaps` their number; gaps that only rounding makes (1 um) are bridged but not counted.
polygon::Loops bridges(const polygon::Loops& loops, double width, double& gap_area, std::size_t& gaps);

// What bodies wind round together.  `body` numbers the body of each loop; a body is where its loops wind round at all,
// if it is hollow, where they do so more often as a body than as a cavity.  Near n log n, however many lie in one
// place.
polygon::Loops unite_bodies(const polygon::Loops& loops, const std::vector<std::uint32_t>& body,
                            const std::vector<char>& hollow);

// What of the plane at height z lies within a surface that is not closed: `walls` part the plane, those of the surface
// marked and with the weight 1, others with 0; within is where the surface winds round a face's borders by more than
// one half, on average over their length.
polygon::Loops solid_within(const std::vector<polygon::Wall>& walls, const mesh::Winding& surface, double z);

// The same area with gaps and slivers below `hairline` mm healed and noted; slivers only where bodies met, if `united`:
// what is thin by itself stays.  Precondition: simple loops.
polygon::Loops heal_hairlines(polygon::Loops loops, bool united, double hairline, std::int64_t layer, Notes& notes);

} // namespace filum::slice
