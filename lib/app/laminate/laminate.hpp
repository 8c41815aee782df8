// The whole job of `laminate`: surfaces and a list of plies in, a toolpath and a map out.
#pragma once

#include "cli/command.hpp"
#include "laminate/laminate.hpp"

namespace filum::app::laminate {

struct Options {
    std::string plies = "0,45,-45,90", table, reference = "X", ramp; // as users have them
    std::string map, trim_list;                                      // files
    std::string machine;                                             // profile that must allow turns outside
    bool symmetric = false;
    filum::laminate::Ply like; // what plies are that neither says
    std::int64_t tool = 0;
    filum::laminate::Options how;
};

// "1:20" as 20, "" as 0.  Throws Error(usage).
double ramp(const std::string& words);

// What a table's word says of where plies lie: "faces:3,4", or a file of curves.  Throws Error: usage, io, bad_input.
filum::laminate::Area within(const std::string& word);

// Reads surfaces, lays the plies on each, and writes one toolpath; the map's surfaces to a file if asked.
// Throws Error as laminate() does, or as plies are read.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::laminate
