// Where distance is zero: places and lines on a surface.
#pragma once

#include "surface/section.hpp"

#include <vector>

namespace filum::geodesic {

using geom::Vec3;
using surface::Surface;

using surface::Segment;

struct Sources {
    std::vector<std::uint32_t> vertices;
    std::vector<Segment> segments;
    [[nodiscard]] bool empty() const { return vertices.empty() && segments.empty(); }
};

} // namespace filum::geodesic
