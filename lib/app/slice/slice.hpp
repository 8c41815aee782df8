// The whole job of `slice`: meshes in, layers out.
#pragma once

#include "cli/command.hpp"
#include "mesh/place.hpp"
#include "mesh/step/step.hpp"
#include "slice/compensate.hpp"
#include "slice/slice.hpp"

namespace filum::app::slice {

struct Options {
    mesh::Placement place;
    filum::slice::Options slice;
    filum::slice::Compensation compensation;
    std::vector<double> shrinkage{0}; // %, one or one per axis: what a part loses of its size as it cools
    mesh::step::Tessellation step;
    std::vector<double> cut_below{}, cut_above{}; // mm; none: not cut
    std::int64_t from_layer = 0;
    std::string machine;     // profile of the one that the part must fit, see machine::load_profile; none: not checked
    std::int64_t copies = 1; // of each input
    std::int64_t plate = 1;  // of a slicer's project, from 1
    std::string grid;        // "4x3": a part in each place of a grid
    std::vector<double> pitch{}; // mm, of the grid
    std::int64_t wells = 0;      // of a plate, in each of which the part is made; 0: there is no plate
    std::string in_wells;        // "A1,B3"; none: all
    std::vector<double> apart;   // mm between several parts; none: as the head's shape needs it
};

// Whether the parts stand in a grid.
inline bool in_grid(const Options& o) { return !o.grid.empty() || o.wells != 0; }

// Reads and places the mesh, checks its size, cuts it, and writes its layers as they come.  Throws Error as those do.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::slice
