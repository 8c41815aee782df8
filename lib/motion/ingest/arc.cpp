#include "ingest/arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::ingest {

namespace {

using geom::Vec2;

constexpr double kRound = 2 * std::numbers::pi;
constexpr double kFewest = 8; // least number of lines of a full circle

// The centre of an arc with a radius: left of the chord for a counter-clockwise shorter arc.
std::optional<Vec2> centre_by_radius(Vec2 from, Vec2 to, const ArcWords& w) {
    const Vec2 way = to - from;
    const double d = norm(way), r = std::abs(*w.r);
    if (!(d > 0) || r < d / 2 * (1 - 1e-6)) return std::nullopt;
    const double h = std::sqrt(std::max(r * r - d * d / 4, 0.0));
    const bool left = w.clockwise == (*w.r < 0);
    const Vec2 across{-way.y / d, way.x / d};
    return from + 0.5 * way + (left ? h : -h) * across;
}

} // namespace

std::vector<Vec3> arc_points(const Vec3& from, const Vec3& to, const ArcWords& w, double tolerance) {
    std::optional<Vec2> centre;
    if (w.i || w.j)
        centre = (w.from_begin ? from.xy() : Vec2{}) + Vec2{w.i.value_or(0), w.j.value_or(0)};
    else if (w.r)
        centre = centre_by_radius(from.xy(), to.xy(), w);
    if (!centre) return {};
    const Vec2 a = from.xy() - *centre, b = to.xy() - *centre;
    const double radius = norm(a);
    if (!(radius > 0)) return {};
    double sweep = std::atan2(a.x * b.y - a.y * b.x, dot(a, b));
    if (w.clockwise) sweep = -sweep;
    if (sweep <= 0 || from.xy() == to.xy()) sweep = from.xy() == to.xy() ? kRound : sweep + kRound;
    sweep += kRound * (std::max(w.turns, 1) - 1);
    const double step = radius > tolerance ? 2 * std::acos(1 - tolerance / radius) : kRound / kFewest;
    const double lines = std::ceil(sweep / std::min(step, kRound / kFewest));
    const double end = norm(b), begin = std::atan2(a.y, a.x);
    std::vector<Vec3> out;
    for (double k = 1; k < lines; ++k) {
        const double f = k / lines, angle = begin + (w.clockwise ? -sweep : sweep) * f;
        const double r = radius + (end - radius) * f;
        out.push_back({centre->x + r * std::cos(angle), centre->y + r * std::sin(angle), from.z + (to.z - from.z) * f});
    }
    out.push_back(to);
    return out;
}

} // namespace filum::ingest
