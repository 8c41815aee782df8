// One curve, printed.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// Prints one curve of the front region; the last one is left where the next region can be reached, if it can.
void print_curve(State& state, const Entry& entry, bool last);

} // namespace filum::link3d
