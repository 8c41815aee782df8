// The table that the part stands on: how bright it is around the part.
#pragma once

#include "render/tubes.hpp"

#include <vector>

namespace filum::render {

// Direction to the lamp, blurred as a lamp of some size is; `k` and `seed` choose where on the lamp.
geom::Vec3 lamp_ray(geom::Vec3 lamp, std::uint32_t seed, std::uint32_t k);

class Table {
  public:
    // A square of half side `radius` around the origin at height `floor`, in the space of `tubes`.
    Table(const Tubes& tubes, geom::Vec3 lamp, double floor, double radius, int threads);
    // Brightness at a point, 1 where nothing dims it; fades to 1 towards the border.
    [[nodiscard]] float at(double x, double y) const;

  private:
    double radius_;
    std::vector<float> bright_;
};

} // namespace filum::render
