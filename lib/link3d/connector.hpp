// Joins to regions that do not lie above: strands that are not part of the part.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// A connector outside everything printed to whichever place of the front region makes it the shortest; close to the
// part, or where the head must come down beside it, as far away as the head is wide.  Nothing if there is no such way.
std::optional<Entry> go_around(State& state);

// A strand straight over to the front region, if that is on the same layer and nothing of it is crossed.
std::optional<Entry> go_inside(State& state);

// Whether p, on the layer of the front region, has a straight way out of the part, or over to the next region, that
// crosses nothing of `own`.
bool sees_outside(const State& state, Vec2 p, const SegmentIndex& own);

} // namespace filum::link3d
