// The whole job of `supports`: reads regions and writes them with regions of supports.
#pragma once

#include "cli/command.hpp"
#include "supports/supports.hpp"

namespace filum::app::supports {

struct Options {
    filum::supports::Options how;
    double angle_deg = 45, taper_deg = 30;
    std::string on = "everywhere";
    std::string wanted, unwanted; // files of bodies; "": none
};

// Reads regions and writes them with supports.  Throws Error as supports(), and for bodies that cannot be read or
// placed.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::supports
