// The whole job of `slice`: a mesh in, layers out.
#pragma once

#include "cli/command.hpp"
#include "mesh/place.hpp"
#include "mesh/step/step.hpp"
#include "slice/slice.hpp"

namespace filum::app::slice {

struct Options {
    mesh::Placement place;
    filum::slice::Options slice;
    mesh::step::Tessellation step;
    std::string machine; // profile of the one that the part must fit, see machine::load_profile; none: not checked
};

// Reads and places the mesh, checks its size, cuts it, and writes its layers as they come.  Throws Error as those do.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::slice
