// Shows the progress of a chain of stages on a terminal.
#pragma once

#include "app/filum/process.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// As run_piped, with a line on standard error that is updated: the first stage that has not ended, its progress, and
// the seconds since the start.  The environment variable FILUM_PROGRESS holds the number of the file descriptor to
// which stages write lines "NAME DONE EXPECTED" (see cli::Progress).  `names`: the names of the stages.
std::vector<ProcessEnd> run_watched(const std::vector<Command>& commands, const std::vector<std::string>& copies,
                                    const std::vector<std::string>& names, NotePrinters speakers);

} // namespace filum::app::filum
