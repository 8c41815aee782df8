#include "toolpath/curve_place.hpp"

#include "geom/segment.hpp"
#include "toolpath/merge.hpp"

#include <algorithm>
#include <limits>

namespace filum::toolpath {

using geom::Vec2;

std::vector<double> arc_lengths(const Curve& c) {
    std::vector<double> out{0};
    const std::size_t n = c.points.size() + (c.closed ? 1 : 0);
    for (std::size_t i = 1; i < n; ++i)
        out.push_back(out.back() + geom::distance(c.points[i - 1], c.points[i % c.points.size()]));
    return out;
}

CurvePlace place_at(const Curve& c, const std::vector<double>& sums, double along) {
    const auto after = std::upper_bound(sums.begin() + 1, sums.end() - 1, along);
    const auto i = static_cast<std::size_t>(after - sums.begin()) - 1;
    const double l = sums[i + 1] - sums[i], t = l > 0 ? std::clamp((along - sums[i]) / l, 0.0, 1.0) : 0;
    return {i, t, geom::lerp(c.points[i], c.points[(i + 1) % c.points.size()], t), along, 0};
}

CurvePlace nearest_place(const Curve& c, const std::vector<double>& sums, Vec2 p) {
    CurvePlace best;
    best.off = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < sums.size(); ++i) {
        const Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
        const double t = geom::nearest_parameter(a, b, p);
        const Vec2 q = geom::lerp(a, b, t);
        if (const double d = geom::distance(p, q); d < best.off)
            best = {i, t, q, sums[i] + t * (sums[i + 1] - sums[i]), d};
    }
    return best;
}

double width_at(const Curve& c, const CurvePlace& p) {
    const double a = c.width_at(p.i), b = c.width_at((p.i + 1) % c.points.size());
    return a + p.t * (b - a);
}

void add_stretch(const Curve& c, const CurvePlace& from, const CurvePlace& to, Curve& out) {
    const std::size_t n = c.points.size();
    const std::size_t vertices = to.i - from.i + (to.along < from.along ? n : 0); // between both places
    add_point(out, from.point, width_at(c, from));
    for (std::size_t k = 1; k <= vertices; ++k)
        add_point(out, c.points[(from.i + k) % n], c.width_at((from.i + k) % n));
    add_point(out, to.point, width_at(c, to));
}

void add_point(Curve& to, Vec2 p, double width) {
    if (!to.points.empty() && geom::distance(to.points.back(), p) < kLeastMove / 2) return;
    to.add(p, width);
}

} // namespace filum::toolpath
