// The whole job of `ingest`: a program in, a toolpath out.
#pragma once

#include "cli/command.hpp"
#include "ingest/reader.hpp"

#include <string>

namespace filum::app::ingest {

struct Options : filum::ingest::Options {
    long plate = 0;           // of a project, from 1; 0: the first
    std::string machine, set; // profile; none: three axes and an extruder word E
};

void run(const Options& options, const cli::Io& io);

} // namespace filum::app::ingest
