// The whole job of `geodesic`: reads a model and writes a surface with distances.
#pragma once

#include "app/geodesic/shape.hpp"
#include "geodesic/measure.hpp"

#include <string>

namespace filum::app::geodesic {

struct Options {
    mesh::Placement place;
    Shaping shape;
    std::string source;      // words for geodesic::named_sources, where the distance is 0; "": none
    std::string lines, mesh; // names of files with further sources
    filum::geodesic::Options measure;
    mesh::step::Tessellation step;
};

// Reads and shapes the model, measures distances, and writes the surface.  Throws Error as read(), shape(),
// geodesic::measure and write(); usage for isolines or sides without a source.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::geodesic
