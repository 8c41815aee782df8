// The whole job of `route`: plans the travels of a toolpath so that they do not collide.
#pragma once

#include "app/collide/surroundings.hpp"
#include "cli/command.hpp"

#include <string>
#include <vector>

namespace filum::app::route {

struct Options : collide::Surroundings {
    std::vector<double> lift;       // mm; empty: as in the profile
    double tilt = 0, tilt_rate = 5; // deg, deg/mm
    double bath = 0;                // mm that travels keep from beads in a bath of gel; 0: no bath
    std::string leaning;            // file for the list of strokes with a tilted tool; "": none
};

// Writes the toolpath with the planned travels.  Throws Error: failure at a remaining collision, with its place, if
// `strict`; usage for options that do not go together.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::route
