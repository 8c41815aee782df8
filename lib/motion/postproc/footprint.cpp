#include "postproc/footprint.hpp"

#include "geom/hull.hpp"

namespace filum::postproc {

void Footprint::add(const geom::Vec2& point, double radius) {
    constexpr std::size_t most = 4096; // points; more are reduced to their hull
    for (const geom::Vec2 by : {geom::Vec2{radius, 0}, {-radius, 0}, {0, radius}, {0, -radius}})
        points_.push_back(point + by);
    if (points_.size() > most) points_ = hull();
}

std::vector<geom::Vec2> Footprint::hull() const { return geom::convex_hull(points_); }

} // namespace filum::postproc
