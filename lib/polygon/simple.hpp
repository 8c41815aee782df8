// A quick proof that loops need no union.
#pragma once

#include "polygon/loops.hpp"

namespace filum::polygon {

inline constexpr double kGridPerMm = 1e4; // grid units: clip.hpp rounds to 0.1 um

// True if `loops` are, exactly, the outline of the area they wind round: on the grid of 0.1 um to which clip.hpp
// rounds, no two edges cross, touch or overlap, and outer loops run counter-clockwise, holes clockwise, nested in turn.
// Then a union would give them back as they are.  False proves nothing but that a union is in order. A sweep that stops
// at the first doubt (Shamos and Hoey 1976), with exact integers; some 50 ns per point, against more than 1 us of the
// union.  Precondition: coordinates within 1e8 mm.
bool is_simple(const Loops& loops);

} // namespace filum::polygon
