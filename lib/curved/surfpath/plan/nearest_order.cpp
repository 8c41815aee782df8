#include "surfpath/plan/nearest_order.hpp"

#include "geom/nearest_points.hpp"

namespace filum::surfpath::plan {

std::vector<Visit> nearest_order(std::span<const EndPoints> ends) {
    std::vector<Vec3> points;
    for (const EndPoints& e : ends) points.insert(points.end(), {e.begin, e.end});
    geom::NearestPoints left(points);
    for (std::uint32_t i = 0; i < points.size(); ++i) left.insert(i);
    std::vector<Visit> out;
    for (std::uint32_t at = 0; !left.empty();) {
        if (!out.empty()) at = *left.nearest(points[at]);
        out.push_back({at / 2, at % 2 == 1});
        left.remove(at);
        at ^= 1U;
        left.remove(at);
    }
    return out;
}

} // namespace filum::surfpath::plan
