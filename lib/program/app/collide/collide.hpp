// The whole job of `collide`: checks a toolpath or a program for collisions.
#pragma once

#include "app/collide/surroundings.hpp"
#include "cli/command.hpp"

#include <string>
#include <vector>

namespace filum::app::collide {

struct Options : Surroundings {
    std::string program;             // file of machine code, checked instead of a toolpath
    std::string format = "table";    // format of the program's figures
    std::vector<double> bead, shift; // see collision/program.hpp
};

// Writes the toolpath with notes and facts on its collisions, or the figures of the program.  Throws Error: failure at
// a collision, with its place, if `strict`; usage for options that do not go together.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::collide
