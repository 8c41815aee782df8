// The whole job of `collide`: a toolpath or a program in, checked against everything that is given.
#pragma once

#include "app/collide/surroundings.hpp"
#include "cli/command.hpp"

#include <string>
#include <vector>

namespace filum::app::collide {

struct Options : Surroundings {
    std::string program;             // machine code to check instead of a toolpath
    std::string format = "table";    // of the program's figures
    std::vector<double> bead, shift; // see collision/program.hpp
};

// Passes the toolpath on with what was found, or writes the figures of the program.  Throws Error(failure) with the
// place at a collision, if `strict`; Error(usage) for options that do not go together.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::collide
