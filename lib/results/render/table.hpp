// The table under the part: its brightness around the part.
#pragma once

#include "render/tubes.hpp"

#include <vector>

namespace filum::render {

// A direction to the lamp, blurred for a lamp of some size. `k` and `seed` choose a point on the lamp.
geom::Vec3 lamp_ray(geom::Vec3 lamp, std::uint32_t seed, std::uint32_t k);

class Table {
  public:
    // A square around the origin at height `floor` with half side `radius`, in the space of `tubes`.
    Table(const Tubes& tubes, geom::Vec3 lamp, double floor, double radius, int threads);
    // The brightness at a point: 1 in full light. It fades to 1 towards the border.
    [[nodiscard]] float at(double x, double y) const;

  private:
    double radius_;
    std::vector<float> bright_;
};

} // namespace filum::render
