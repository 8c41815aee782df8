// The whole job of `laminate`: surfaces and a list of plies in, a toolpath and a map out.
#pragma once

#include "cli/command.hpp"
#include "laminate/laminate.hpp"

namespace filum::app::laminate {

struct Options {
    std::string plies = "0,45,-45,90", table, reference = "X", map; // as users have them
    bool symmetric = false;
    filum::laminate::Ply like; // what plies are that neither says
    std::int64_t tool = 0;
    filum::laminate::Options how;
};

// Reads surfaces, lays the plies on each, and writes one toolpath; the map's surfaces to a file if asked.
// Throws Error as laminate() does, or as plies are read.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::laminate
