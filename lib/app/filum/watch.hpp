// How far a chain of stages is, on a terminal.
#pragma once

#include "app/filum/process.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// run_piped, with a line on standard error that is drawn anew: the first stage that has not ended, how far it says it
// is, and since when the chain runs.  Stages are told by the environment variable FILUM_PROGRESS where to write lines
// "NAME DONE EXPECTED" (cli::Progress does).
std::vector<Ended> run_watched(const std::vector<Command>& commands, const std::vector<std::string>& copies,
                               const std::vector<std::string>& names, Speakers speakers);

} // namespace filum::app::filum
