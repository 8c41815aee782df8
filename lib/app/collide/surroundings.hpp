// What the commands about collisions are told of the machine and of what stands there: `collide` and `route` alike.
#pragma once

#include "cli/spec.hpp"
#include "collision/check.hpp"
#include "machine/head.hpp"

#include <string>
#include <vector>

namespace filum::app::collide {

struct Surroundings {
    collision::Options check;
    machine::HeadChoice head;
    std::string machine;       // profile: name or file; "": three axes and the head alone
    std::string set;           // changes to the profile
    std::string part, fixture; // mesh files, commas between
    std::string places;        // file for the list of collisions
    bool bed = false, strict = true;
};

// The options that fill it, and those of them that stand together in the help, but for the head's.
std::vector<cli::Option> options(Surroundings& to);
cli::Group group();

} // namespace filum::app::collide
