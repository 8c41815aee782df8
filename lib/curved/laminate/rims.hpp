// Closed beads along rims that keep the turns of plies apart.
#pragma once

#include <cstddef>
#include <vector>

namespace filum::laminate {

// The beads along every rim of a ply; its rows turn inside of them.
struct RimBeads {
    long count = 0;
    double width = 1; // spacings, of each

    [[nodiscard]] double depth() const { return static_cast<double>(count) * width; } // spacings from the rim
};

// Share of the surface that the ply leaves open at a distance `from_rim` (spacings). Rows at right angles to the rim
// turn in half circles of half a spacing, so what they cover ends in half circles of a spacing, two spacings apart.
// These begin at the rim, or rules::kOnRimBead outside of the ply's depth.
double open_share(const RimBeads& ply, double from_rim);

// The beads of each of `plies`, at most `most` of them, whose widths may differ from a spacing by the share `change`.
// Ply k takes depth k modulo the number of depths. Depths begin with 0 or with one narrow bead and are as far apart as
// possible. Of these, those count for which the greatest sum of open shares at any distance from the rim is least;
// ties: the smaller number of depths, then 0.
std::vector<RimBeads> rim_beads(std::size_t plies, long most, double change);

} // namespace filum::laminate
