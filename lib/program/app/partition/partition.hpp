// The whole job of `partition`: reads surfaces and writes patches.
#pragma once

#include "cli/command.hpp"
#include "partition/partition.hpp"

#include <string>

namespace filum::app::partition {

struct Options {
    filum::partition::Options how;
    std::string cases, names, only; // lists with commas between
    std::string seam;               // file of lines that no patch crosses; "": none
    bool as_is = false;             // a surface without a name is a patch, too
};

// Reads all inputs and divides the surfaces that are no patches yet.  Names the patches and writes the requested ones,
// with facts on each.  Throws Error as partition::divide, the parsers of names and the readers.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::partition
