// Prints one curve of a region.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// Prints one curve of the front region. If it is the `last` one, it ends where the next region can be reached, if
// possible.
void print_curve(State& state, const Entry& entry, bool last);

} // namespace filum::link3d
