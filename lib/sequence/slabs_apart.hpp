// An order with places where everything below must be there before anything above begins.
#pragma once

#include "machine/pauses.hpp"
#include "sequence/sequence.hpp"

namespace filum::sequence {

// As sequence(), of what lies between two pauses each by itself, one slab after the other; without ends and graph. Each
// slab gets its share of the budget by its regions.  Counts and bounds are the sums: no order that waits there has
// fewer strokes.  Slabs without regions are none.
Result sequence_apart(const std::vector<polygon::Region>& regions, const Options& options,
                      const machine::Pauses& pauses);

} // namespace filum::sequence
