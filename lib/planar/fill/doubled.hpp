// Material on material where a curve turns back on itself.
#pragma once

#include "toolpath/path.hpp"

#include <span>

namespace filum::fill {

// What curves cover twice at sharp turns.
struct Doubled {
    double area = 0; // mm2
    geom::Vec2 at;   // the turn with the largest part of it
};

// Measures the area that curves cover twice where they turn by more than a right angle. The tightest turn without
// overlap is a half circle whose diameter is the bead's width. Points of a curve at equal distances along it from the
// apex of a turn that are nearer to each other than on this half circle share material: as many mm of width as they are
// nearer. The apex is where they are nearest; the measure ends at the apex of the next turn. Overlap of different turns
// is not measured, so the area is a lower bound. Takes linear time, except for the turns found.
Doubled doubled_at_turns(std::span<const toolpath::Curve> curves);

} // namespace filum::fill
