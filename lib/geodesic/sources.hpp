// Where distance is zero: places and lines on a surface.
#pragma once

#include "surface/surface.hpp"

#include <vector>

namespace filum::geodesic {

using geom::Vec3;
using surface::Surface;

// A straight line within one triangle, borders included; a point if both ends are the same.
struct Segment {
    std::uint32_t triangle = 0;
    Vec3 a, b; // mm; in the triangle's plane
};

struct Sources {
    std::vector<std::uint32_t> vertices;
    std::vector<Segment> segments;
    [[nodiscard]] bool empty() const { return vertices.empty() && segments.empty(); }
};

} // namespace filum::geodesic
