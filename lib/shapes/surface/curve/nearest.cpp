#include "surface/curve/nearest.hpp"

#include "geom/segment.hpp"

#include <cmath>

namespace filum::surface::curve {

namespace {

void consider(const Line& line, std::span<const double> ways, const Vec3& p, std::size_t i, NearestWay& best) {
    const Vec3 &a = line[i], d = line[(i + 1) % line.size()] - a;
    const double t = geom::nearest_parameter(a, a + d, p);
    if (const double far = distance(p, a + t * d); far < best.distance) best = {far, ways[i] + t * norm(d)};
}

} // namespace

NearestWay nearest(const Line& line, std::span<const double> ways, const Vec3& p) {
    NearestWay out;
    for (std::size_t i = 0; i + 1 < ways.size(); ++i) consider(line, ways, p, i, out);
    return out;
}

NearestWay nearest_beside(const Line& line, std::span<const double> ways, const Vec3& p, std::size_t i) {
    NearestWay out;
    consider(line, ways, p, i, out);
    consider(line, ways, p, (i + line.size() - 1) % line.size(), out);
    return out;
}

} // namespace filum::surface::curve
