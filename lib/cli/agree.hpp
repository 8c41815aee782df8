// Whether a stage was told the same as the stages before it: Option::same_as.
#pragma once

#include "cli/command.hpp"

namespace filum::cli {

// One note per setting of this run (the last of the history) that a stage before has otherwise: of several runs of that
// program the last counts.  A setting that only one of the two has counts as other where it is not at its default.
Notes disagreements(const Io& io, const stream::Header& header);

} // namespace filum::cli
