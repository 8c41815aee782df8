// The whole job of `postproc`: a toolpath in, a program out, or several files of one.
#pragma once

#include "cli/command.hpp"
#include "postproc/options.hpp"

namespace filum::app::postproc {

// Throws as what it calls; no file appears unless all do.
void run(const filum::postproc::Options& options, const cli::Io& io);

} // namespace filum::app::postproc
