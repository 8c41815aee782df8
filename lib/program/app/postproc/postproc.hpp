// The whole job of `postproc`: reads a toolpath and writes a program of one or several files.
#pragma once

#include "cli/command.hpp"
#include "postproc/options.hpp"

namespace filum::app::postproc {

// Reads the toolpath and writes the program.  Files appear only if all of them are complete.  Throws Error.
void run(const filum::postproc::Options& options, const cli::Io& io);

} // namespace filum::app::postproc
