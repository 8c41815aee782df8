// Rings along the outline, a zigzag in the core: the 2019 paper's Cs&zigzag and Pc&zigzag (Table I, samples 9 and 10).
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill {

struct RingedZigzagOptions {
    double bead_width = 0.4; // mm
    double angle = 0;        // rad, of the rows from the x axis
    int rings = 2;           // along the outline, at least 1
    bool linked = true;      // one closed curve of all; else each ring and each part of the core is one
};

// Fills one connected region (outer loop first, then holes): `rings` rings as in `spiral`, thin walls followed, and in
// every part of what is left the corridors of `zigzag`, whose outline is just one more ring inside the others.  Linked,
// all are joined by exchanges to one closed curve (docs/algorithms/fill.md: a core that is one more loop keeps it one).
// The result is checked and made again as in `zigzag`.  Order: longest first if linked, else from outside inwards.
// Note: curves that could not be joined (count).  `unplaced`, where given, is set to the area that no bead reaches,
// mm2.
std::vector<toolpath::Curve> ringed_zigzag(const polygon::Loops& region, const RingedZigzagOptions& options,
                                           Notes& notes, double* unplaced = nullptr);

} // namespace filum::fill
