// Compensates outlines for beads that a machine deposits wider or narrower than planned.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"

namespace filum::slice {

struct Compensation {
    double elephant_foot = 0; // mm by which the outline of the first layer moves inwards
    double xy = 0;            // mm by which every outline moves outwards and holes shrink; negative: inwards
    double holes = 0;         // mm by which holes widen in addition; negative: shrink

    [[nodiscard]] bool any() const { return elephant_foot != 0 || xy != 0 || holes != 0; }
};

// The compensated outlines of a layer. On layer 0, the elephant foot takes at most half of the width anywhere: areas
// narrower than four times its value stay, with a note of their area. A note also reports the area that disappears when
// outlines move inwards. Corners that grow become round, and contours stay simple. `bores` are the bores that the layer
// leaves open (bores.hpp); their walls move as those of holes do.
polygon::Loops compensated(const polygon::Loops& contours, const polygon::Loops& bores, const Compensation& by,
                           std::uint32_t layer, Notes& notes);

} // namespace filum::slice
