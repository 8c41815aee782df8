// The whole job of `skins`: regions in, the same with areas out.
#pragma once

#include "cli/command.hpp"
#include "skins/skins.hpp"

namespace filum::app::skins {

struct Options {
    filum::skins::Options how;
    std::string infill = "15%", pattern = "rows"; // as users have them
    std::string modifiers;                        // FILE:SETTINGS or PROJECT.3mf, several with ';' between
};

// Throws Error as skins() does, for texts that mean nothing, and for modifiers that cannot be read or placed.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::skins
