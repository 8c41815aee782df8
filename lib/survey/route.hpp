// The whole job of `route`: a toolpath in, the same with ways for its travels out.
#pragma once

#include "cli/command.hpp"
#include "collision/check.hpp"
#include "machine/head.hpp"

#include <string>
#include <vector>

namespace filum::survey {

struct RouteOptions {
    collision::Options check;
    machine::HeadChoice head;
    std::string machine;            // profile: name or file; "": the head alone
    std::string set;                // changes to the profile
    std::string part, fixture;      // mesh files, commas between
    std::string places, leaning;    // files: the list of collisions that remain, of strokes whose tool leans
    std::vector<double> lift;       // mm; none: the profile's
    double tilt = 0, tilt_rate = 5; // deg, deg/mm
    bool bed = false, strict = true;
};

// Throws Error(failure) with the place at a collision that remains, if `strict`; Error(usage) for options that do not
// go together.
void route(const RouteOptions& options, const cli::Io& io);

} // namespace filum::survey
