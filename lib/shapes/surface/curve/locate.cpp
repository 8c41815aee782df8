#include "surface/curve/locate.hpp"

#include <array>

namespace filum::surface::curve {

namespace {

std::vector<geom::Box3> boxes(const Surface& s) {
    std::vector<geom::Box3> out;
    out.reserve(s.triangles.size());
    for (const auto& [a, b, c] : s.triangles)
        out.push_back(geom::box_of(std::array{s.vertices[a], s.vertices[b], s.vertices[c]}));
    return out;
}

} // namespace

Locator::Locator(const Surface& surface) : surface_(surface), tree_(boxes(surface)) {}

Place Locator::search(const Vec3& p, const Vec3* normal, double most) const {
    Place best{kNone, {}};
    double least = most;
    tree_.near(p, least, [&](std::uint32_t t) {
        if (normal && !(dot(surface::normal(surface_, t), *normal) > 0)) return least;
        const Vec3 q = surface::nearest_in(surface_, t, p);
        const double d = distance(p, q);
        if (d < least || (d == least && t < best.triangle)) {
            least = d;
            best = {t, q};
        }
        return least;
    });
    return best;
}

} // namespace filum::surface::curve
