// The whole job of `slice`: reads meshes and writes layers.
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
    double first_layer_width = 0;     // mm, of the beads of the first layer; 0: as those of other layers
    std::vector<double> shrinkage{0}; // %, one or one per axis: the loss of size as a part cools
    mesh::step::Tessellation step;
    std::vector<double> cut_below{}, cut_above{}; // mm, z of the cuts; empty: no cut
    std::int64_t from_layer = 0;                  // first layer to write, from 0
    std::string machine;     // profile of the machine that the part must fit (machine::load_profile); "": not checked
    std::string set;         // changes to that profile, or, without one, to marlin's
    std::int64_t copies = 1; // number of copies of each input
    std::int64_t plate = 1;  // number of the plate in a slicer's project, from 1
    std::string grid;        // such as "4x3": a part in each place of a grid; "": no grid
    std::vector<double> pitch{}; // mm, distances of places in the grid
    std::int64_t wells = 0;      // number of wells of the plate that the parts are made in; 0: no plate
    std::string in_wells;        // names of wells, such as "A1,B3"; "": all
    std::string body;            // further bodies of the part, see bodies.hpp; "": none
    std::vector<double> apart;   // mm between several parts; empty: as the shape of the head requires
};

// Whether the parts stand in a grid.
inline bool in_grid(const Options& o) { return !o.grid.empty() || o.wells != 0; }

// Reads and places the meshes, checks their size, cuts them, and writes each layer as soon as it is ready.  Throws
// Error as these steps.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::slice
