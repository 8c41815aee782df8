// Sources of distances: vertices and segments on a surface where distance is zero.
#pragma once

#include "surface/section.hpp"
#include "surface/surface.hpp"

#include <vector>

namespace filum::surface {

struct Sources {
    std::vector<std::uint32_t> vertices;
    std::vector<Segment> segments;
    [[nodiscard]] bool empty() const { return vertices.empty() && segments.empty(); }
};

// The side of a rim given by its half-edge.
inline Segment rim_side(const Surface& s, std::uint32_t h) {
    return {h / 3, s.vertices[s.tail(h)], s.vertices[s.head(h)]};
}

// All sides of all rims, in their order.
inline Sources rim_sources(const Surface& s) {
    Sources out;
    for (const auto& rim : s.rims)
        for (const std::uint32_t h : rim.sides) out.segments.push_back(rim_side(s, h));
    return out;
}

} // namespace filum::surface
