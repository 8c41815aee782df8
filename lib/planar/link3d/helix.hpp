// Helical z (docs/algorithms/link3d.md#ramps-and-helices): each turn of a column rises evenly by one layer. It is as
// thick as the gap to the turn below.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// Whether the front region, entered at `entry`, and the next one can be turns of one helix.
bool winds_on(const State& state, const Entry& entry);

// Prints the front region's only curve as a turn that rises from the nozzle's height. If the helix ends here (not
// `goes_on`), a level turn follows at its top and adds the missing material. Returns the line of the turn as a bead.
Bead wind(State& state, const Entry& entry, bool goes_on);

} // namespace filum::link3d
