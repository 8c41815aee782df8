// Where a stroke begins, and where a column is entered on its way up.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// The first place of a stroke in the front region.
Entry start_entry(const State& state);

// The other end of the region's only curve, an open one, if beginning there it ends nearer to the next region.
std::optional<Entry> other_end(const State& state, const Entry& entry);

// Another place in reach of the nozzle, nearer to where the column goes, that can be reached without crossing a bead;
// only as far as it must be to be there in time.  `nearest` if there is none.
Entry drift(State& state, const Entry& nearest);

} // namespace filum::link3d
