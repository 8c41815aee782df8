// The whole job of `partition`: surfaces in, patches out.
#pragma once

#include "cli/command.hpp"
#include "partition/partition.hpp"

#include <string>

namespace filum::app::partition {

struct Options {
    filum::partition::Options how;
    std::string cases, names, only; // words with commas between
    std::string seam;               // file of lines that are borders
    bool as_is = false;             // surfaces without a name are patches, too
};

// Reads all inputs, divides what is no patch yet, names the patches and writes those asked for, with facts on each.
// Throws Error as partition::divide, names and readers do.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::partition
