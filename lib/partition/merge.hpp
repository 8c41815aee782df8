// Cells grown together into patches.
#pragma once

#include "partition/proxy.hpp"

namespace filum::partition {

struct Limits {
    double angle_deg = 30;    // of directions from their patch's mean; a twentieth, by weight, may be beyond
    double bend_deg = 50;     // of normals from their patch's mean; a twentieth, by area, may be beyond
    std::int64_t patches = 0; // merge until so many are left, whatever the angles; 0: as far as the angles allow
    double least_area = 0;    // mm2: smaller patches merge with a neighbour, whatever the angles, within half_round()
};

// Per cell the number of its patch, by first cells.  At first every cell is one; the two neighbours merge whose spread
// grows least for the length of border that goes (Koepfler, Lopez, Morel 1994, "A multiscale algorithm for image
// segmentation by variational method"), of equals those with the lesser first cells.  Border across strong directions
// counts up to four times that along them or without load: there fibres would be cut.
std::vector<std::uint32_t> merge(const Cells& cells, const Pull& pull, const Limits& limits);

// How much the border between two cells counts, 1 to 4 times its length.
double border_factor(const Pull& pull, const Side& side);

} // namespace filum::partition
