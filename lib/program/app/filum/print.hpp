// `filum print`: runs the whole planar chain as one command.
#pragma once

#include <string>
#include <vector>

namespace filum::app::filum {

// Runs the chain with the options `words`, and returns its exit code.  With --help or --dry-run it prints text instead.
// On a terminal it shows the progress of the slowest stage, and at the end a summary of the program.  Throws Error.
int print_part(const std::vector<std::string>& words);

} // namespace filum::app::filum
