// The area that beads cover, seen from above.
#pragma once

#include "geom/vec.hpp"

#include <vector>

namespace filum::postproc {

// Collects points, and keeps only those that can be corners of their convex hull.
class Footprint {
  public:
    void add(const geom::Vec2& point, double radius); // of a circle around `point`: its extreme points in x and y
    [[nodiscard]] std::vector<geom::Vec2> hull() const;

  private:
    std::vector<geom::Vec2> points_;
};

} // namespace filum::postproc
