#include "surface/curve/strip.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace filum::surface::curve {

namespace {

constexpr int kMostRounds = 100;            // of shortening
constexpr double kAtRest = 1e-9;            // reaches: shortening ends when no place moves farther
constexpr std::size_t kMostTriangles = 1e5; // triangles

// The half-edges that are crossed from a to b, in order.
std::vector<std::uint32_t> strip(const Surface& s, const Place& a, const Place& b, double reach) {
    std::map<std::uint32_t, std::uint32_t> entry{
        {a.triangle, kNone}}; // per triangle the half-edge by which it is entered
    std::vector<std::uint32_t> front{a.triangle};
    for (std::size_t i = 0; i < front.size() && entry.count(b.triangle) == 0 && i < kMostTriangles; ++i)
        for (std::uint32_t h = 3 * front[i]; h < 3 * front[i] + 3; ++h) {
            const std::uint32_t twin = s.twin[h];
            if (twin == kNone || entry.count(twin / 3) != 0) continue;
            if (distance(nearest_in(s, twin / 3, a.point), a.point) > reach) continue;
            entry[twin / 3] = h;
            front.push_back(twin / 3);
        }
    std::vector<std::uint32_t> out;
    if (entry.count(b.triangle) == 0) return out;
    for (std::uint32_t t = b.triangle; t != a.triangle; t = out.back() / 3) out.push_back(entry[t]);
    std::reverse(out.begin(), out.end());
    return out;
}

// Where the straight way between two points crosses a half-edge if its two triangles are unfolded into a plane.
Vec3 crossing(const Surface& s, std::uint32_t h, const Vec3& from, const Vec3& to) {
    const Vec3 &p = s.vertices[s.tail(h)], d = s.vertices[s.head(h)] - p;
    const double l = norm(d);
    if (!(l > 0)) return p;
    const Vec3 u = 1 / l * d;
    const double x = dot(from - p, u), y = dot(to - p, u);
    const double left = norm(from - p - x * u), right = norm(to - p - y * u);
    const double at = left + right > 0 ? (x * right + y * left) / (left + right) : (x + y) / 2;
    return p + std::clamp(at, 0.0, l) * u;
}

} // namespace

Line through_strip(const Surface& s, const Place& a, const Place& b, double reach) {
    if (a.triangle == b.triangle) return {{a, b}, false};
    const auto edges = strip(s, a, b, reach);
    if (edges.empty()) return {};
    std::vector<Vec3> at{a.point};
    for (const std::uint32_t h : edges) at.push_back(crossing(s, h, at.back(), b.point));
    at.push_back(b.point);
    double moved = reach;
    for (int round = 0; round < kMostRounds && moved > kAtRest * reach; ++round) {
        moved = 0;
        for (std::size_t i = 1; i + 1 < at.size(); ++i) {
            const Vec3 now = crossing(s, edges[i - 1], at[i - 1], at[i + 1]);
            moved = std::max(moved, distance(now, at[i]));
            at[i] = now;
        }
    }
    Line out{{a}, false};
    for (std::size_t i = 0; i < edges.size(); ++i) out.places.push_back({s.twin[edges[i]] / 3, at[i + 1]});
    out.places.push_back(b);
    return out;
}

} // namespace filum::surface::curve
