// Where distance is zero: places and lines on a surface.
#pragma once

#include "surface/section.hpp"

#include <vector>

namespace filum::surface {

struct Sources {
    std::vector<std::uint32_t> vertices;
    std::vector<Segment> segments;
    [[nodiscard]] bool empty() const { return vertices.empty() && segments.empty(); }
};

} // namespace filum::surface
