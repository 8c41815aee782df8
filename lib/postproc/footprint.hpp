// Where beads lie, seen from above.
#pragma once

#include "geom/vec.hpp"

#include <vector>

namespace filum::postproc {

// Gathers points and keeps only those that can be corners of their convex hull.
class Footprint {
  public:
    void add(const geom::Vec2& point, double radius); // the circle about it, by the four points of it on the axes
    [[nodiscard]] std::vector<geom::Vec2> hull() const;

  private:
    std::vector<geom::Vec2> points_;
};

} // namespace filum::postproc
