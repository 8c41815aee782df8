// `filum print`: the whole planar chain as one command.
#pragma once

#include <string>
#include <vector>

namespace filum::app::filum {

// Runs the chain that the words ask for, or tells of it, and returns its exit code.  On a terminal it shows how far the
// slowest stage is, and at the end what was made.  Throws Error.
int print_part(const std::vector<std::string>& words);

} // namespace filum::app::filum
