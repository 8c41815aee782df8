// Reading the command line into the bound options; private to lib/cli.
#pragma once

#include "cli/command.hpp"

namespace filum::cli {

// Fills the options and `io`.  Returns text to print instead of running (help, version, documents), or "".
// Throws Error(usage).
std::string parse(int argc, char** argv, const Spec& spec, Io& io);

} // namespace filum::cli
