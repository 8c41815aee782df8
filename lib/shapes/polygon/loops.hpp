// Sets of closed polygons: the data that all planar stages share.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::polygon {

using geom::Box2;
using geom::Vec2;

// Closed polygons in one array; loop i is points[start[i] .. start[i + 1]), its last point not repeated, mm.
struct Loops {
    std::vector<Vec2> points;
    std::vector<std::uint32_t> start{0};

    [[nodiscard]] std::size_t size() const { return start.size() - 1; }
    [[nodiscard]] bool empty() const { return size() == 0; }
    [[nodiscard]] std::span<const Vec2> operator[](std::size_t i) const {
        return {points.data() + start[i], start[i + 1] - start[i]};
    }
    void add(std::span<const Vec2> loop) {
        points.insert(points.end(), loop.begin(), loop.end());
        close();
    }
    void add(const Loops& more) {
        const auto shift = static_cast<std::uint32_t>(points.size());
        points.insert(points.end(), more.points.begin(), more.points.end());
        for (std::size_t l = 1; l < more.start.size(); ++l) start.push_back(more.start[l] + shift);
    }
    // Ends the loop whose points were pushed directly.
    void close() { start.push_back(static_cast<std::uint32_t>(points.size())); }
};

double signed_area(std::span<const Vec2> loop); // mm2, positive if counter-clockwise
double signed_area(const Loops& loops);         // mm2, the sum over the loops: the area, if holes are clockwise
Vec2 centroid(const Loops& loops);              // of the area; the first point if the area is 0
double perimeter(std::span<const Vec2> loop);   // mm
Box2 bounds(std::span<const Vec2> points);
inline Box2 bounds(const Loops& loops) { return bounds(loops.points); }

// Even-odd test of p against all loops; points on an edge may fall on either side.
bool contains(const Loops& loops, Vec2 p);

} // namespace filum::polygon
