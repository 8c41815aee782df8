// Thin walls printed in two passes, one on top of the other (docs/algorithms/fill.md).
#pragma once

#include "link3d/ramp.hpp"

#include <optional>
#include <utility>

namespace filum::link3d {

using geom::Vec3;

// The walls of one region that its curves pass twice along one line, and the stretches of them that are printed
// already.
class StackedWalls {
  public:
    explicit StackedWalls(const std::vector<std::vector<Vec2>>& lines);

    // The bead in a layer that ends at `z` and is `height` mm thick. The first pass along a wall lies half a layer
    // lower than the rest, and the second pass lies on it. Both are half as thick and twice as wide as the bead says.
    // The nozzle changes its height over `ramp` mm, at most half a segment. The bead begins at z.
    SpatialBead lay(const Bead& bead, double z, double height, double ramp);

  private:
    enum class Pass { plain, lower, upper };
    Pass pass(Vec2 a, Vec2 b);

    std::vector<toolpath::Curve> lines_;
    std::vector<std::vector<double>> along_;                   // mm from the start, per point
    std::vector<std::vector<std::pair<double, double>>> laid_; // per line, disjoint
    std::optional<SegmentIndex> index_;
};

} // namespace filum::link3d
