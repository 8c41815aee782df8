// The front command: `filum STAGE ...`, `filum print`, `filum list`, `filum env`, `filum help`.
#pragma once

#include "cli/spec.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// Runs the command that the first word names, and returns its exit code.  If the first word names a stage, this process
// is replaced by the stage.  Throws Error.
int front(const std::vector<std::string>& words);

} // namespace filum::app::filum
