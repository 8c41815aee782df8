#include "surface/directions/cells.hpp"

#include "surface/curve/line.hpp"

#include <algorithm>

namespace filum::surface::directions {

namespace {

// Limits that prevent negative diffusion across obtuse angles, and keep slivers from spoiling the system.
constexpr double kLeastConductance = 0.01, kMostConductance = 100;

// Cotangent of the angle opposite to side `h`.
double cotangent(const Surface& s, std::uint32_t h) {
    const Vec3 at = s.vertices[s.tail(surface::prev(h))];
    const Vec3 u = s.vertices[s.tail(h)] - at, v = s.vertices[s.head(h)] - at;
    return dot(u, v) / norm(cross(u, v));
}

// Distance from the middle of side `h` to the middle of its triangle.
double half_border(const Surface& s, std::uint32_t h) {
    const Vec3 a = s.vertices[s.tail(h)], b = s.vertices[s.head(h)], c = s.vertices[s.tail(surface::prev(h))];
    return distance(0.5 * (a + b), (1.0 / 3) * (a + b + c));
}

} // namespace

Cells cells(const Surface& s) {
    Cells out;
    out.normal = surface::curve::vertex_normals(s);
    out.area.assign(s.vertices.size(), 0);
    double length = 0;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const std::uint32_t twin = s.twin[h];
        if (h % 3 == 0) {
            const double area = surface::area(s, h / 3);
            for (const auto v : s.triangles[h / 3]) out.area[v] += area / 3;
            out.total += area;
        }
        if (twin != kNone && twin < h) continue;
        CellBorder side{.a = std::min(s.tail(h), s.head(h)), .b = std::max(s.tail(h), s.head(h))};
        const Vec3 way = s.vertices[side.b] - s.vertices[side.a];
        side.way = 1 / norm(way) * way;
        side.border = half_border(s, h);
        side.conductance = cotangent(s, h) / 2;
        if (twin != kNone) {
            side.border += half_border(s, twin);
            side.conductance += cotangent(s, twin) / 2;
        }
        side.conductance = std::clamp(side.conductance, kLeastConductance, kMostConductance);
        length += norm(way);
        out.sides.push_back(side);
    }
    std::sort(out.sides.begin(), out.sides.end(),
              [](const CellBorder& x, const CellBorder& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    out.mean_side = length / static_cast<double>(out.sides.size());
    return out;
}

Vec3 turned(const Vec3& v, const Vec3& from, const Vec3& to) {
    const double c = dot(from, to);
    if (c < -1 + 1e-12) return v - 2 * dot(v, across(from)) * across(from); // half a turn: the axis is arbitrary
    const Vec3 axis = cross(from, to);
    return v + cross(axis, v) + 1 / (1 + c) * cross(axis, cross(axis, v));
}

Vec3 across(const Vec3& n) {
    const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    const Vec3 least = x <= y && x <= z ? Vec3{1, 0, 0} : (y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1});
    const Vec3 out = cross(n, least);
    return 1 / norm(out) * out;
}

double percentile(std::vector<std::pair<double, double>> all, double share) {
    std::sort(all.begin(), all.end());
    double total = 0, sum = 0;
    for (const auto& [value, weight] : all) total += weight;
    for (const auto& [value, weight] : all)
        if (weight > 0 && (sum += weight) >= share * total) return value;
    return 0;
}

} // namespace filum::surface::directions
