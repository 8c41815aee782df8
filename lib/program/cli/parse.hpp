// Reads the command line into the bound options; private to lib/program/cli.
#pragma once

#include "cli/command.hpp"

namespace filum::cli {

// Fills the options bound in `spec`, and `io`. Returns the text to print instead of running (help, version, documents),
// or "" to run. Throws Error(usage).
std::string parse(int argc, char** argv, const Spec& spec, Io& io);

} // namespace filum::cli
