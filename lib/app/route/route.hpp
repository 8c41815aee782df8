// The whole job of `route`: a toolpath in, the same with ways for its travels out.
#pragma once

#include "app/collide/surroundings.hpp"
#include "cli/command.hpp"

#include <string>
#include <vector>

namespace filum::app::route {

struct Options : collide::Surroundings {
    std::vector<double> lift;       // mm; none: the profile's
    double tilt = 0, tilt_rate = 5; // deg, deg/mm
    std::string leaning;            // file for the list of strokes whose tool leans
};

// Throws Error(failure) with the place at a collision that remains, if `strict`; Error(usage) for options that do not
// go together.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::route
