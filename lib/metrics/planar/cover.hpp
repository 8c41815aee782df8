// How much of an area a set of beads covers.
//
// Areas are swept by horizontal rows.  On a row every bead and every outline is a set of intervals with exact ends, so
// there is no rounding along x at all; along y the error of one row is second order in the spacing.  Rows lie half a
// spacing off the lower edge of the outlines and divide their height evenly: bead borders at whole spacings fall
// between rows.
#pragma once

#include "polygon/loops.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::metrics::planar {

// A straight bead with round ends.  `slot` says which outline it was meant for.
struct Bead {
    geom::Vec2 a, b;
    double width = 0; // mm, > 0
    std::uint32_t slot = 0;
    std::uint32_t order = 0;    // in the program
    float from_z = 0, to_z = 0; // mm, at a and b
    float thick = 1;            // of its layer
};

// All in mm2.
struct Cover {
    double area = 0;      // inside the outline
    double covered = 0;   // of it, under beads
    double united = 0;    // under beads
    double deposited = 0; // sum of length * width * thickness, of the layer: what is extruded

    [[nodiscard]] double outside() const { return united - covered; }
    // Material laid where there is some already (less the round ends, which lie outside the sum of length * width).
    [[nodiscard]] double overfill() const { return deposited - united; }
    [[nodiscard]] double unplaced() const { return area - covered; }
};

struct LayerCover {
    Cover whole;             // all beads against all outlines
    std::vector<Cover> slot; // the beads of a slot against its own outline
};

// `outline[k]` belongs to slot k (even-odd; null: no outline); `spacing` > 0 mm between rows, enlarged if more than
// 200,000 rows were needed.  Every bead's slot is below outline.size().
LayerCover cover(std::span<const Bead> beads, std::span<const polygon::Loops* const> outline, double spacing);

} // namespace filum::metrics::planar
