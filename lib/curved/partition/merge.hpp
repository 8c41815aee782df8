// Merges cells to patches.
#pragma once

#include "partition/proxy.hpp"

namespace filum::partition {

struct Limits {
    double angle_deg = 30; // largest angle of directions from the patch's mean; a twentieth, by weight, may exceed it
    double bend_deg = 50;  // largest angle of normals from the patch's mean; a twentieth, by area, may exceed it
    std::int64_t patches = 0; // merge until this many remain, regardless of the angles; 0: as far as the angles allow
    // mm2: smaller patches are merged with a neighbour that may_take() them, regardless of the angles
    double least_area = 0;
};

// Per cell the number of its patch, by first cells. Starts with one patch per cell; always merges the two neighbours
// for which the spread grows least per length of border removed (Koepfler, Lopez, Morel 1994, "A multiscale algorithm
// for image segmentation by variational method"); ties: those with the lowest first cells. Border across strong
// directions counts up to four times as much as along them or without load, since fibres would be cut there.
std::vector<std::uint32_t> merge(const Cells& cells, const Pull& pull, const Limits& limits);

// Weight of the border between two cells, 1 to 4.
double border_factor(const Pull& pull, const CellBorder& side);

} // namespace filum::partition
