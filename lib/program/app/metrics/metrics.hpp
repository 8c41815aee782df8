// The whole job of `metrics`: reads streams and writes figures.
#pragma once

#include "cli/command.hpp"
#include "metrics/planar/report.hpp"
#include "metrics/surface/report.hpp"

namespace filum::app::metrics {

struct Options {
    filum::metrics::planar::Options plane;   // for toolpaths in layers
    filum::metrics::surface::Options curved; // for paths on a surface
    std::string surface, voids, map;         // names of files; "": none
};

// Measures the input and writes all requested tables.  With `surface` the input is a path on that surface, and figures
// on layers are left out.  Throws Error: usage for options that do not go together, bad_input for a stream of another
// kind.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::metrics
