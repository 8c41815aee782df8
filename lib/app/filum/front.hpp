// The front command: `filum STAGE ...`, `filum print`, `filum list`, `filum env`, `filum help`.
#pragma once

#include "cli/spec.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// Does what the words ask for and returns the exit code; becomes the stage where the first word names one.
// Throws Error.
int front(const std::vector<std::string>& words);

} // namespace filum::app::filum
