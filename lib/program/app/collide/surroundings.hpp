// The machine and the obstacles, as `collide` and `route` take them from their options.
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
    std::string set;           // changes to the profile: KEY=VALUE,...
    std::string part, fixture; // names of mesh files, with commas between; obstacles from the start
    std::string places;        // file for the list of collisions (TSV); "": none
    bool bed = false, strict = true;
};

// options(): the options that fill `to`.  group(): those of them that form one group in the help; the options of the
// head have a group of their own.
std::vector<cli::Option> options(Surroundings& to);
cli::Group group();

} // namespace filum::app::collide
