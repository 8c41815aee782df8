// The whole job of `geodesic`: a model in, a surface with distances out.
#pragma once

#include "app/geodesic/shape.hpp"
#include "geodesic/measure.hpp"

#include <string>

namespace filum::app::geodesic {

struct Options {
    mesh::Placement place;
    Shaping shape;
    std::string source; // where distance is 0, in the words of geodesic::named_sources; none: only the surface is made
    std::string lines, mesh; // files of further sources
    filum::geodesic::Options measure;
    mesh::step::Tessellation step;
};

// Reads, shapes, measures and writes the model.  Throws Error as those do; usage for isolines or sides without a
// source.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::geodesic
