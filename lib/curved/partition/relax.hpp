// Moves the borders of patches to make them short and the patches coherent.
#pragma once

#include "partition/proxy.hpp"

namespace filum::partition {

struct Borders {
    std::vector<std::uint32_t> patch; // per cell
    std::vector<double> at;           // per border of cells of two patches: share of the way from a to b; otherwise 0
};

// Moves the borders of patches, given as numbers per cell, towards the least sum of the misfit of cells to their patch
// times area, and of border length times `length` mm (border across strong directions counts more, as in merge());
// patches may vanish. Threshold dynamics: each patch is diffused, and a cell joins the patch of the greatest value
// less its misfit (Esedoglu, Otto 2015, "Threshold dynamics for networks with arbitrary surface tensions"). Finally
// borders are placed between the cells by one step of diffusion alone. Same result for any `threads`.
Borders relax(std::vector<std::uint32_t> patch, const Cells& cells, const Pull& pull, double length, int threads);

// Two patches: 1 where the value, diffused over `length` mm, is above the level, otherwise 0; the border is the
// isoline of the level.
Borders above(const std::vector<double>& value, double level, const Cells& cells, double length);

} // namespace filum::partition
