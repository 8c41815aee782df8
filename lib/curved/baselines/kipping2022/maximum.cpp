#include "baselines/kipping2022/maximum.hpp"

#include <algorithm>

namespace filum::baselines::kipping2022 {

namespace {

// All vertices connected to `from` above the level; none if one of them was seen before.
std::vector<std::uint32_t> above(const Surface& s, std::span<const double> values, double level, std::uint32_t from,
                                 std::vector<char>& seen) {
    std::vector<std::uint32_t> out;
    const auto visit = [&](std::uint32_t v) {
        if (seen[v] == 0 && values[v] >= level) {
            seen[v] = 1;
            out.push_back(v);
        }
    };
    visit(from);
    for (std::size_t i = 0; i < out.size(); ++i)
        surface::each_outgoing(s, out[i], [&](std::uint32_t h) {
            visit(s.head(h));
            visit(s.tail(surface::prev(h)));
        });
    return out;
}

// Starts with the point farthest from the centre; next is always the nearest remaining one.
Points ordered(Points points) {
    if (points.empty()) return points;
    Vec3 middle;
    for (const Vec3& p : points) middle = middle + 1.0 / static_cast<double>(points.size()) * p;
    const auto farthest = std::max_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
        return distance(middle, a) < distance(middle, b);
    });
    std::iter_swap(points.begin(), farthest);
    for (auto now = points.begin(); now + 1 != points.end(); ++now)
        std::iter_swap(now + 1, std::min_element(now + 1, points.end(), [&](const Vec3& a, const Vec3& b) {
                           return distance(*now, a) < distance(*now, b);
                       }));
    return points;
}

} // namespace

Points maximum(const Surface& s, std::span<const double> values, double level, std::uint32_t from, double tolerance,
               double apart, std::vector<char>& seen) {
    std::vector<std::uint32_t> inside = above(s, values, level, from, seen);
    std::sort(inside.begin(), inside.end(),
              [&](std::uint32_t a, std::uint32_t b) { return values[a] != values[b] ? values[a] > values[b] : a < b; });
    Points out;
    for (const std::uint32_t v : inside) {
        if (values[v] < values[inside.front()] - tolerance) break;
        const Vec3& p = s.vertices[v];
        if (std::all_of(out.begin(), out.end(), [&](const Vec3& q) { return distance(p, q) >= apart; }))
            out.push_back(p);
    }
    return ordered(std::move(out));
}

} // namespace filum::baselines::kipping2022
