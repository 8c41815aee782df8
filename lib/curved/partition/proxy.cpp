#include "partition/proxy.hpp"

#include <algorithm>
#include <numbers>

namespace filum::partition {

Vec3 Proxy::normal() const { return geom::unit(facing, {0, 0, 1}); }

bool may_take(const Vec3& facing, double area, const Vec3& small, double small_area) {
    constexpr double kHalf = 2 / std::numbers::pi;
    return norm(facing + small) >= kHalf * (area + small_area) || norm(facing) < kHalf * area;
}

Proxy proxy(const Cells& cells, const Pull& pull, std::size_t v) {
    const double weight = pull.known(v) ? cells.area[v] * pull.trust[v] : 0;
    return {cells.area[v], cells.area[v] * cells.normal[v], weight, pull.along[v], weight};
}

Proxy joined(const Proxy& a, const Proxy& b) {
    Proxy out{a.area + b.area, a.facing + b.facing, a.weight + b.weight, {}, 0};
    const Vec3 n = out.normal();
    const Vec3 x = geom::unit(turned(a.along, a.normal(), n), {}), y = geom::unit(turned(b.along, b.normal(), n), {});
    if (norm(x) == 0 || norm(y) == 0) {
        out.along = norm(x) == 0 ? y : x;
        out.agreed = a.agreed + b.agreed;
        return out;
    }
    const double turn = 2 * std::atan2(dot(cross(x, y), n), dot(x, y));
    const double re = a.agreed + b.agreed * std::cos(turn), im = b.agreed * std::sin(turn);
    const double half = std::atan2(im, re) / 2;
    out.agreed = std::hypot(re, im);
    out.along = geom::unit(std::cos(half) * x + std::sin(half) * cross(n, x), {});
    return out;
}

double angle_from(const Proxy& p, const Vec3& normal, const Vec3& along) {
    if (norm(p.along) == 0 || norm(along) == 0) return 0;
    return std::acos(std::min(1.0, std::abs(dot(turned(along, normal, p.normal()), p.along))));
}

double bend_from(const Proxy& p, const Vec3& normal) {
    return std::acos(std::clamp(dot(p.normal(), normal), -1.0, 1.0));
}

double misfit(const Proxy& p, const Cells& cells, const Pull& pull, std::size_t v) {
    const double angle = angle_from(p, cells.normal[v], pull.along[v]);
    return 1 - dot(p.normal(), cells.normal[v]) + pull.trust[v] * (1 - std::cos(2 * angle));
}

} // namespace filum::partition
