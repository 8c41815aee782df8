// The whole job of `ingest`: reads a program and writes its toolpath.
#pragma once

#include "cli/command.hpp"
#include "ingest/reader.hpp"

#include <string>

namespace filum::app::ingest {

struct Options : filum::ingest::Options {
    long plate = 0;           // number of the plate in a project, from 1; 0: the first plate
    std::string machine, set; // profile and changes to it; "": three axes and an extruder word E
};

void run(const Options& options, const cli::Io& io);

} // namespace filum::app::ingest
