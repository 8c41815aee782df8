#include "toolpath/extent.hpp"

#include <algorithm>
#include <cmath>

namespace filum::toolpath {

namespace {

bool is_part(Feature f) {
    return f != Feature::support && f != Feature::interface && f != Feature::skirt && f != Feature::tower;
}

// Vertical extent of a bead, which extends half its width across the tool's axis, and its height down
// that axis from the tip.
struct VerticalExtent {
    double below, above;
};
VerticalExtent reach(double width, double height, double axis) {
    const double side = width / 2 * std::sqrt(std::max(0.0, 1 - axis * axis)), down = height * axis;
    return {side + std::max(0.0, down), side + std::max(0.0, -down)};
}

} // namespace

void Extent::add(const Span& span) {
    if (!fills(span.role) || !is_part(span.feature)) return;
    for (std::size_t i = 0; i < span.points.size(); ++i) {
        const double w = span.width_at(i), h = span.height_at(i);
        const Vec3 p = span.points[i], n = span.normals.empty() ? Vec3{0, 0, 1} : span.normals[i];
        const VerticalExtent x = reach(w, h, n.x), y = reach(w, h, n.y), z = reach(w, h, n.z);
        low = {std::min(low.x, p.x - x.below), std::min(low.y, p.y - y.below), std::min(low.z, p.z - z.below)};
        high = {std::max(high.x, p.x + x.above), std::max(high.y, p.y + y.above), std::max(high.z, p.z + z.above)};
    }
}

} // namespace filum::toolpath
