// Orders jobs with pauses, at which everything below must be printed.
#pragma once

#include "machine/pauses.hpp"
#include "sequence/sequence.hpp"

namespace filum::sequence {

// Applies sequence() to the layers between two pauses, one slab after the other; without ends and graph. Each slab
// gets a share of the budget by its regions. Counts and bounds are sums: no order with these pauses has fewer strokes.
// Empty slabs are skipped.
SequenceResult sequence_apart(const std::vector<polygon::Region>& regions, const Options& options,
                              const machine::Pauses& pauses);

} // namespace filum::sequence
