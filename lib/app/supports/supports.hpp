// The whole job of `supports`: regions in, the same with those that carry them out.
#pragma once

#include "cli/command.hpp"
#include "supports/supports.hpp"

namespace filum::app::supports {

struct Options {
    filum::supports::Options how;
    double angle_deg = 45, taper_deg = 30;
    std::string on = "everywhere";
    std::string wanted, unwanted; // files of bodies
};

// Throws Error for bodies that cannot be read or placed.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::supports
