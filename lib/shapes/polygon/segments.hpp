// The edges of polygons as segments.
#pragma once

#include "geom/segment_grid.hpp"
#include "polygon/loops.hpp"

#include <vector>

namespace filum::polygon {

// One segment per point, from it to the next point of its loop, in the order of the points.
inline std::vector<geom::Segment> segments(const Loops& loops) {
    std::vector<geom::Segment> out;
    out.reserve(loops.points.size());
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const auto loop = loops[l];
        for (std::size_t i = 0; i < loop.size(); ++i) out.push_back({loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]});
    }
    return out;
}

} // namespace filum::polygon
