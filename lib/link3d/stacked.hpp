// Walls laid in two passes, one on the other (docs/algorithms/fill.md).
#pragma once

#include "link3d/ramp.hpp"

#include <optional>
#include <utility>

namespace filum::link3d {

using geom::Vec3;

// The walls of one region that its curves pass twice on one line, and what of them is laid already.
class Stacked {
  public:
    explicit Stacked(const std::vector<std::vector<Vec2>>& lines);

    // The bead as it lies in a layer that ends at `z`, `height` thick.  Along a wall the first pass lies half a layer
    // lower than the rest, the second on it; both are half as thick and twice as wide as the bead says.  The nozzle
    // gets from one to the other along `ramp` mm, at most half a segment, so the bead begins at z.
    Laid lay(const Bead& bead, double z, double height, double ramp);

  private:
    enum class Pass { plain, lower, upper };
    Pass pass(Vec2 a, Vec2 b);

    std::vector<toolpath::Curve> lines_;
    std::vector<std::vector<double>> along_;                   // mm from the start, per point
    std::vector<std::vector<std::pair<double, double>>> laid_; // per line, disjoint
    std::optional<SegmentIndex> index_;
};

} // namespace filum::link3d
