// Borders between patches made short, smooth, and best for the patches.
#pragma once

#include "partition/proxy.hpp"

namespace filum::partition {

struct Borders {
    std::vector<std::uint32_t> patch; // per cell
    std::vector<double> at;           // per side of Cells between two patches: share of the way from a to b; else 0
};

// Moves the borders of the patches, as numbers per cell, towards the least sum of misfit to the mean of each patch
// times area, and of border length times `length` mm (border across strong directions counts more, as in merge);
// patches may vanish.  Threshold dynamics: each patch spreads by diffusion, and a cell goes where the most of it comes
// from, less the misfit (Esedoglu, Otto 2015, "Threshold dynamics for networks with arbitrary surface tensions").  At
// last borders are placed between the cells by one step of diffusion alone.
Borders relax(std::vector<std::uint32_t> patch, const Cells& cells, const Pull& pull, double length);

// Two patches: 1 where the value, spread by diffusion over `length` mm, is above the level, else 0; borders where it is
// the level.
Borders above(const std::vector<double>& value, double level, const Cells& cells, double length);

} // namespace filum::partition
