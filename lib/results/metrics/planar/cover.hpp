// The area that a set of beads covers.
// Areas are integrated along horizontal rows. On a row every bead and every outline is a set of intervals with exact
// ends, so there is no rounding along x; along y the error is second order in the spacing of the rows. Rows are half a
// spacing from the lower edge of the outlines and divide their height evenly: edges of beads at whole spacings are
// between rows. Long beads are measured tile by tile instead (cover_tiles.hpp).
#pragma once

#include "polygon/loops.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::metrics::planar {

// A straight bead with round ends. `slot` is the index of its outline.
struct Bead {
    geom::Vec2 a, b;
    double width = 0; // mm, > 0
    std::uint32_t slot = 0;
    std::uint32_t order = 0;    // in printing order
    float from_z = 0, to_z = 0; // mm, at a and b
    float thick = 1;            // fraction of its layer's height
};

// All in mm2.
struct Cover {
    double area = 0;    // inside the outline
    double covered = 0; // mm2 of it under beads
    double united = 0;  // mm2 under beads, inside and outside
    // mm2: sum of length * width * thickness (fraction of the layer): the extruded volume over the height
    double deposited = 0;

    [[nodiscard]] double outside() const { return united - covered; }
    // Material on places that already have some (minus the round ends, which are not part of the sum of length *
    // width).
    [[nodiscard]] double overfill() const { return deposited - united; }
    [[nodiscard]] double unplaced() const { return area - covered; }
};

struct LayerCover {
    Cover whole;             // all beads with all outlines
    std::vector<Cover> slot; // the beads of a slot with its own outline
};

// `outline[k]` belongs to slot k (even-odd; null: no outline). `spacing` > 0: mm between rows, increased if more than
// 200,000 rows would be needed. Precondition: the slot of every bead is below outline.size().
LayerCover cover(std::span<const Bead> beads, std::span<const polygon::Loops* const> outline, double spacing);

} // namespace filum::metrics::planar
