// Finds settings of this run that differ from those of earlier stages: see Option::same_as.
#pragma once

#include "cli/command.hpp"

namespace filum::cli {

// One note for each setting in io.same whose value differs from that of an earlier stage. This run is the last one in
// header.history; if a program ran several times, its latest run counts. A setting that only one of the two runs has
// differs if it is not at its default.
Notes disagreements(const Io& io, const stream::Header& header);

} // namespace filum::cli
