// The whole job of `skins`: reads regions and writes them with areas of sparse and solid infill.
#pragma once

#include "cli/command.hpp"
#include "skins/skins.hpp"

namespace filum::app::skins {

struct Options {
    filum::skins::Options how;
    std::string infill = "15%", pattern = "rows"; // as the user types them
    std::string modifiers;                        // FILE:SETTINGS or PROJECT.3mf; ';' between several
};

// Reads regions and writes them with areas.  Throws Error as skins(), for texts in `options` that cannot be parsed, and
// for modifiers that cannot be read or placed.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::skins
