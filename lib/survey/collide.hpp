// The whole job of `collide`: a toolpath or a program in, checked against everything that is given.
#pragma once

#include "cli/command.hpp"
#include "collision/check.hpp"
#include "machine/head.hpp"

#include <string>
#include <vector>

namespace filum::survey {

struct CollideOptions {
    collision::Options check;
    machine::HeadChoice head;
    std::string machine;             // profile: name or file; "": three axes and the head alone
    std::string set;                 // changes to the profile
    std::string part, fixture;       // mesh files, commas between
    std::string places;              // file for the list of collisions
    std::string program;             // machine code to check instead of a toolpath
    std::string format = "table";    // of the program's figures
    std::vector<double> bead, shift; // see collision/program.hpp
    bool bed = false, strict = true;
};

// Passes the toolpath on with what was found, or writes the figures of the program.  Throws Error(failure) with the
// place at a collision, if `strict`; Error(usage) for options that do not go together.
void collide(const CollideOptions& options, const cli::Io& io);

} // namespace filum::survey
