// Several bodies, or one that touches itself: one area, without the hairlines that rounding and facets leave between
// faces that should be one; private to lib/slice.
#pragma once

#include "base/note.hpp"
#include "polygon/clip.hpp"

namespace filum::slice {

// Patches that bridge every gap of at most `width` mm between two edges that face each other across it, reaching a
// little into the solid on both sides; counter-clockwise, to be united with `loops`.  `gap_area` gets the area of the
// gaps, mm2, `gaps` their number; gaps that only rounding makes (1 um) are bridged but not counted.
polygon::Loops bridges(const polygon::Loops& loops, double width, double& gap_area, std::size_t& gaps);

// The area that `loops` wind round, as simple loops, with gaps and slivers below `hairline` mm healed and noted.
polygon::Loops unite_bodies(const polygon::Loops& loops, polygon::Fill rule, double hairline, std::int64_t layer,
                            Notes& notes);

} // namespace filum::slice
