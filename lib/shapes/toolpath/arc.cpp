#include "toolpath/reach.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace filum::toolpath {

namespace {

constexpr double kMostSweep = 1.8 * std::numbers::pi; // rad: the end of a full circle is ill-defined
constexpr double kMostRadius = 1000;                  // mm: firmware computes in single precision

struct Circle {
    Vec2 centre;
    double radius = 0, sweep = 0;
};

// The circle through both ends whose greatest distance from the points between, and from the middles of the segments,
// is almost minimal. Its centre is t to the left of the middle between the ends; each point bounds t.
std::optional<Circle> circle(const Line& line, std::uint32_t from, std::uint32_t to, double most) {
    const Vec2 a = line.points[from].xy(), b = line.points[to].xy(), middle = 0.5 * (a + b);
    const double half = geom::distance(a, b) / 2;
    if (!(half > 0)) return std::nullopt;
    const Vec2 left = geom::left_of((0.5 / half) * (b - a));
    double highest = 0, t = 0;
    for (std::uint32_t k = from + 1; k < to; ++k) {
        const Vec2 p = line.points[k].xy() - middle;
        if (const double v = dot(p, left); std::abs(v) > std::abs(highest)) {
            highest = v;
            t = (norm2(p) - half * half) / (2 * v);
        }
    }
    if (std::abs(highest) < most) return std::nullopt; // a straight move is sufficient
    const double reach = 2 * most * std::hypot(half, t);
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    const auto bound = [&](Vec2 at) {
        const Vec2 p = at - middle;
        const double g = norm2(p) - half * half, v = 2 * dot(p, left);
        const double one = (g - reach) / v, other = (g + reach) / v;
        if (std::abs(v) < 1e-12 * half) return;
        low = std::max(low, std::min(one, other));
        high = std::min(high, std::max(one, other));
    };
    for (std::uint32_t k = from + 1; k < to; ++k) {
        const Vec2 p = line.points[k].xy();
        bound(p);
        if (k + 1 < to) bound(geom::lerp(p, line.points[k + 1].xy(), 0.5));
    }
    if (low > high) return std::nullopt;
    t = (low + high) / 2;
    Circle out{middle + t * left, std::hypot(half, t), 0};
    if (out.radius > kMostRadius) return std::nullopt;
    const Vec2 p = a - out.centre, q = b - out.centre;
    out.sweep = std::atan2(geom::cross(p, q), dot(p, q));
    if (highest > 0 && out.sweep > 0) out.sweep -= 2 * std::numbers::pi; // on the left side: clockwise
    if (highest < 0 && out.sweep < 0) out.sweep += 2 * std::numbers::pi;
    if (std::abs(out.sweep) > kMostSweep) return std::nullopt;
    return out;
}

// The greatest distance between arc and line, each point compared with the arc at the same angle; nothing if it
// exceeds `most`, or if the line goes backwards.
std::optional<double> distance_of(const Line& line, std::uint32_t from, std::uint32_t to, const Circle& r,
                                  double most) {
    const double turn = r.sweep > 0 ? 1 : -1;
    Vec2 before = line.points[from].xy() - r.centre, direction = before;
    double worst = std::abs(norm(before) - r.radius), swept = 0;
    for (std::uint32_t k = from + 1; k <= to; ++k) {
        const Vec2 p = line.points[k].xy() - r.centre;
        const double by = turn * std::atan2(geom::cross(direction, p), dot(direction, p));
        if (by < 0) return std::nullopt;
        swept += by;
        // Inside a segment the least distance from the centre is at the foot of the perpendicular.
        const Vec2 way = p - before;
        const double l2 = norm2(way), f = l2 > 0 ? std::clamp(-dot(before, way) / l2, 0.0, 1.0) : 0;
        worst = std::max({worst, std::abs(norm(p) - r.radius), r.radius - norm(before + f * way)});
        if (worst > most) return std::nullopt;
        before = direction = p;
    }
    if (std::abs(swept - std::abs(r.sweep)) > 1e-6) return std::nullopt; // one turn too many, or not complete
    return worst;
}

// The greatest distance between an arc and the chords into which the machine divides it.
double sagitta(const Circle& r, double chord) {
    if (chord == 0) return 0;
    const double sweep = std::abs(r.sweep), pieces = std::max(1.0, std::floor(sweep * r.radius / chord));
    return r.radius * (1 - std::cos(std::min(std::numbers::pi, sweep / pieces / 2)));
}

} // namespace

Arc arc_reach(const Line& line, std::uint32_t from, std::uint32_t least, std::uint32_t last, const Tolerance& t,
              double& off) {
    // Centre and ends are rounded independently.
    const double most = t.path - t.grid;
    Arc out{from, {}, 0};
    double worst = 0;
    const auto fits = [&](std::uint32_t to) {
        Section section(line, from, t.section);
        for (std::uint32_t k = from + 1; k <= to; ++k) section.take(k);
        if (!section.suits()) return false;
        const double may = most * full_share(line, from, line.at[to] - line.at[from]);
        const auto round = circle(line, from, to, may);
        const double inside = round ? sagitta(*round, t.chord) : 0;
        if (inside >= may) return false;
        const auto d = round ? distance_of(line, from, to, *round, may - inside) : std::nullopt;
        if (!d) return false;
        out = {to, round->centre, round->sweep};
        worst = *d + inside;
        return true;
    };
    if (!(most > 0) || least >= last) return out;
    // The first that fits is searched among a few, then the farthest by doubling and bisection.
    constexpr std::uint32_t tried = 4;
    std::uint32_t good = least + 1;
    while (good <= last && good < least + 1 + tried && !fits(good)) ++good;
    if (out.to == from) return out;
    (void)farthest(good, last, fits);
    off = std::max(off, worst);
    return out;
}

} // namespace filum::toolpath
