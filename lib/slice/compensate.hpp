// What a machine lays wider or narrower than it was told, taken off the outlines beforehand.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"

namespace filum::slice {

struct Compensation {
    double elephant_foot = 0; // mm that the outline of the first layer moves inwards
    double xy = 0;            // mm that every outline moves outwards, holes closing; negative: inwards
    double holes = 0;         // mm that holes widen, on top of that; negative: close

    [[nodiscard]] bool any() const { return elephant_foot != 0 || xy != 0 || holes != 0; }
};

// The layer's outlines moved so.  On the first one no place loses more than half of its width to the elephant's foot:
// what is narrower than four times that stays, with a note of its area.  What an inward move leaves nothing of is
// noted, too.  Corners that grow become round; contours stay simple.
// `bores` are those that the layer leaves open (bores.hpp): their walls move as those of holes do.
polygon::Loops compensated(const polygon::Loops& contours, const polygon::Loops& bores, const Compensation& by,
                           std::uint32_t layer, Notes& notes);

} // namespace filum::slice
