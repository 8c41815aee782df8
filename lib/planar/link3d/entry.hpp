// Chooses where a stroke begins, and where a column is entered on its way up.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// The entry of the front region where a new stroke begins, by Options::seam. It is chosen so that the column above can
// be climbed.
Entry start_entry(const State& state);

// The other end of an open curve, if it is the region's only one and a stroke from there ends nearer to the next
// region. Nothing otherwise.
std::optional<Entry> other_end(const State& state, const Entry& entry);

// An entry in reach of the nozzle that is nearer to the first region above that would be out of reach. The jog to it
// crosses no bead. The entry moves only as far as it must to be there in time. Returns `nearest` if there is no such
// place, or if no region is out of reach.
Entry drift(State& state, const Entry& nearest);

} // namespace filum::link3d
