#include "surface/curve/walk.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surface::curve {

namespace {

constexpr double kSteep = 0.17;    // least cosine of the angle between a chart and a triangle
constexpr std::size_t kMost = 1e6; // edges crossed
constexpr double kOutside = -1e-7; // barycentric weight below which a point is outside the triangle
constexpr double kAbove = 1e-5;    // mm from a triangle's plane beyond which a point is off it

// The way through one triangle: the side by which it leaves.
struct TriangleExit {
    std::uint32_t side = kNone; // the half-edge; kNone: the way ends inside
    double part = 1;            // share of the way up to there
};

TriangleExit leave(const std::array<double, 3>& at, const std::array<double, 3>& to, std::uint32_t triangle,
                   std::uint32_t entry) {
    TriangleExit out;
    for (std::uint32_t k = 0; k < 3; ++k) {
        // Corner k's weight falls to 0 on the side opposite to it.
        const std::uint32_t side = 3 * triangle + (k + 1) % 3;
        const double change = to[k] - at[k];
        if (side == entry || !(change < 0) || !(to[k] < 0)) continue;
        const double part = std::max(0.0, at[k]) / -change;
        if (part < out.part) out = {side, part};
    }
    return out;
}

Vec3 in_plane(const Vec3& v, const Vec3& normal) { return v - dot(v, normal) * normal; }

// A vector in the triangle of half-edge `h`, rotated around it into the triangle across.
Vec3 turned_over(const Surface& s, std::uint32_t h, const Vec3& v, const Vec3& from, const Vec3& to) {
    const Vec3 edge = s.vertices[s.head(h)] - s.vertices[s.tail(h)];
    const Vec3 along = 1 / norm(edge) * edge;
    return dot(v, along) * along + dot(v, cross(along, from)) * cross(along, to);
}

// The point moved exactly onto the side, ends included.
Vec3 on_side(const Surface& s, std::uint32_t h, const Vec3& p) {
    const Vec3 &a = s.vertices[s.tail(h)], d = s.vertices[s.head(h)] - a;
    return a + std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0) * d;
}

// Follows the chart from `at` to `target`; whether it arrives.
bool follow(const Surface& s, const Chart& chart, Place& at, Vec2 target, Line& out) {
    std::uint32_t entry = kNone;
    for (std::size_t n = 0; n < kMost; ++n) {
        const Vec3 normal = surface::normal(s, at.triangle);
        const double upright = dot(normal, chart.normal);
        if (upright < kSteep) return false;
        const Vec2 rest = target - chart.to(at.point);
        const Vec3 flat = rest.x * chart.x + rest.y * chart.y;
        const Vec3 way = flat - dot(flat, normal) / upright * chart.normal;
        const auto exit = leave(barycentric(s, at), barycentric(s, {at.triangle, at.point + way}), at.triangle, entry);
        if (exit.side == kNone) {
            at.point = at.point + way;
            out.places.push_back(at);
            return true;
        }
        at.point = on_side(s, exit.side, at.point + exit.part * way);
        entry = s.twin[exit.side];
        if (entry != kNone) at.triangle = entry / 3;
        out.places.push_back(at);
        if (entry == kNone) return false;
    }
    return false;
}

} // namespace

std::array<double, 3> barycentric(const Surface& s, const Place& place) {
    const auto& [a, b, c] = s.triangles[place.triangle];
    const Vec3 ab = s.vertices[b] - s.vertices[a], ac = s.vertices[c] - s.vertices[a];
    const Vec3 ap = place.point - s.vertices[a], n = cross(ab, ac);
    const double f = 1 / dot(n, n), v = dot(cross(ap, ac), n) * f, w = dot(cross(ab, ap), n) * f;
    return {1 - v - w, v, w};
}

bool lies_in(const Surface& s, std::uint32_t triangle, const Vec3& p) {
    const auto w = barycentric(s, {triangle, p});
    if (std::min({w[0], w[1], w[2]}) < kOutside) return false;
    return std::abs(dot(surface::normal(s, triangle), p - s.vertices[s.triangles[triangle][0]])) < kAbove;
}

Place step(const Surface& s, const Place& from, const Vec3& way, Line* crossed) {
    Place at = from;
    std::uint32_t entry = kNone;
    Vec3 normal = surface::normal(s, at.triangle), rest = in_plane(way, normal);
    for (std::size_t n = 0; n < kMost; ++n) {
        const auto exit = leave(barycentric(s, at), barycentric(s, {at.triangle, at.point + rest}), at.triangle, entry);
        at.point = exit.side == kNone ? at.point + rest : on_side(s, exit.side, at.point + exit.part * rest);
        entry = exit.side == kNone ? kNone : s.twin[exit.side];
        if (entry != kNone) at.triangle = entry / 3;
        if (crossed) crossed->places.push_back(at);
        if (entry == kNone) return at;
        const Vec3 beyond = surface::normal(s, at.triangle);
        rest = turned_over(s, exit.side, (1 - exit.part) * rest, normal, beyond);
        normal = beyond;
    }
    return at;
}

Line walk(const Surface& s, const Place& from, const Vec3& direction, double length) {
    Line out{{from}, false};
    const Vec3 along = in_plane(direction, surface::normal(s, from.triangle));
    step(s, from, length / norm(along) * along, &out);
    return out;
}

Chart chart(const Place& place, const Vec3& normal, const Vec3& heading) {
    const Vec3 along = in_plane(heading, normal);
    const Vec3 x = 1 / norm(along) * along;
    return {place.point, x, cross(normal, x), normal};
}

ChartLine from_chart(const Surface& s, const Chart& chart, const Place& from, std::span<const Vec2> way) {
    ChartLine out{{{from}, false}, true};
    Place at = from;
    for (std::size_t i = 1; i < way.size(); ++i)
        if (!follow(s, chart, at, way[i], out.line)) {
            out.whole = false;
            break;
        }
    return out;
}

Line join(const Surface& s, const Place& a, const Place& b) {
    const Vec3 sum = surface::normal(s, a.triangle) + surface::normal(s, b.triangle), way = b.point - a.point;
    if (a.triangle == b.triangle || !(norm(sum) > 0) || !(norm(cross(way, sum)) > 0)) return {{a, b}, false};
    const Chart flat = chart(a, 1 / norm(sum) * sum, way);
    const Vec2 ends[] = {{0, 0}, flat.to(b.point)};
    auto laid = from_chart(s, flat, a, ends);
    if (!laid.whole || distance(laid.line.places.back().point, b.point) > 1e-6 * norm(way)) return {{a, b}, false};
    laid.line.places.back() = b;
    return std::move(laid.line);
}

bool leads(const Surface& s, const Line& joined) {
    return joined.size() != 2 || lies_in(s, joined.places[0].triangle, joined[1]);
}

Line threaded(const Surface& s, const Line& line) {
    Line out{{}, line.closed};
    const std::size_t n = line.size();
    for (std::size_t i = 0; i < n; ++i) {
        out.places.push_back(line.places[i]);
        if (i + 1 == n && !line.closed) break;
        const Place& to = line.places[(i + 1) % n];
        if (lies_in(s, line.places[i].triangle, to.point)) continue;
        const Line way = join(s, line.places[i], to);
        out.places.insert(out.places.end(), way.places.begin() + 1, way.places.end() - 1);
    }
    return out;
}

Place settled(const Surface& s, Place p) {
    for (int round = 0; round < 3; ++round) {
        Place best{p.triangle, nearest_in(s, p.triangle, p.point)};
        double least = distance(best.point, p.point);
        if (least < 1e-9) return best;
        for (const auto v : s.triangles[p.triangle])
            each_outgoing(s, v, [&](std::uint32_t h) {
                const Vec3 q = nearest_in(s, h / 3, p.point);
                if (const double d = distance(q, p.point); d < least) {
                    least = d;
                    best = {h / 3, q};
                }
            });
        if (best.triangle == p.triangle) return best;
        p.triangle = best.triangle;
    }
    return {p.triangle, nearest_in(s, p.triangle, p.point)};
}

} // namespace filum::surface::curve
