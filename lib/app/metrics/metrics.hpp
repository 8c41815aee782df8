// The whole job of `metrics`: streams in, figures out.
#pragma once

#include "cli/command.hpp"
#include "metrics/planar/report.hpp"
#include "metrics/surface/report.hpp"

namespace filum::app::metrics {

struct Options {
    filum::metrics::planar::Options plane;   // of layers
    filum::metrics::surface::Options curved; // of paths on a surface
    std::string surface, voids, map;         // files
};

// Measures the input, and writes all tables that are asked for.  With `surface` the input is a path on it, and what
// tells of layers is left out.  Throws Error(usage) for options that do not go together, Error(bad_input) for streams
// of another kind.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::metrics
