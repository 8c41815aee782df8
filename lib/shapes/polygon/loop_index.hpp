// Finds the loops of a layer near a place.
#pragma once

#include "geom/bvh.hpp"
#include "polygon/loops.hpp"

namespace filum::polygon {

// The loops of a layer, with their boxes in a tree. To compare one region with a whole layer, only the loops
// near that region are needed: a plate of n parts would take n^2 comparisons otherwise.
class LoopIndex {
  public:
    LoopIndex() : LoopIndex(Loops{}) {}
    explicit LoopIndex(Loops loops);

    // The loops whose boxes meet `box`, in their order. No other loop goes round a point of the box, so all winding
    // numbers in the box are those of the whole layer. Takes log n and the points of the loops found.
    [[nodiscard]] Loops near(const Box2& box) const;

  private:
    Loops loops_;
    geom::Bvh boxes_;
};

} // namespace filum::polygon
