// True helical z (docs/algorithms/link3d.md#ramps-and-helices): each turn of a column rises evenly by one layer, as
// thick as the gap to the turn below it.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// Whether the front region, entered there, and the next one can be turns of one helix.
bool winds_on(const State& state, const Entry& entry);

// Prints the front region's one curve as a turn that rises from where the nozzle is.  The last turn of a helix is
// followed by one at its top that lays what is missing there; its end is the bead's that is returned.
Bead wind(State& state, const Entry& entry, bool goes_on);

} // namespace filum::link3d
