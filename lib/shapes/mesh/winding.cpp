#include "mesh/winding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::mesh {

namespace {

constexpr std::uint32_t kLeaf = 8; // most triangles of a leaf
constexpr double kFar = 3;         // in radii of a node: from this distance on, a node counts as one dipole

// The signed solid angle of a triangle, in sr.  a, b and c are relative to the point.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) { // Van Oosterom and Strackee 1983
    const double la = norm(a), lb = norm(b), lc = norm(c);
    return 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

} // namespace

Winding::Winding(const Mesh& mesh, std::span<const Triangle> more) {
    triangles_.reserve(mesh.triangles.size() + more.size());
    for (const auto list : {std::span<const Triangle>(mesh.triangles), more})
        for (const Triangle& t : list)
            triangles_.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
    nodes_.emplace_back();
    if (!triangles_.empty()) split(0, 0, static_cast<std::uint32_t>(triangles_.size()));
}

void Winding::split(std::uint32_t node, std::uint32_t first, std::uint32_t last) {
    Node n;
    double area = 0;
    geom::Box3 middles;
    for (std::uint32_t i = first; i < last; ++i) {
        const auto& [a, b, c] = triangles_[i];
        const Vec3 d = 0.5 * cross(b - a, c - a), m = 1.0 / 3 * (a + b + c);
        const double s = norm(d);
        n.dipole = n.dipole + d;
        n.middle = n.middle + s * m;
        area += s;
        middles.add(m);
    }
    n.middle = area > 0 ? 1 / area * n.middle : 0.5 * (middles.lo + middles.hi);
    for (std::uint32_t i = first; i < last; ++i)
        for (const Vec3& p : {triangles_[i].a, triangles_[i].b, triangles_[i].c})
            n.radius = std::max(n.radius, distance(p, n.middle));
    n.first = first;
    n.count = last - first;
    if (n.count <= kLeaf) {
        nodes_[node] = n;
        return;
    }
    const int axis = geom::longest_axis(middles.size());
    const std::uint32_t middle = first + n.count / 2;
    const auto key = [&](const Corner3& t) {
        return coordinate(t.a, axis) + coordinate(t.b, axis) + coordinate(t.c, axis);
    };
    std::nth_element(triangles_.begin() + first, triangles_.begin() + middle, triangles_.begin() + last,
                     [&](const Corner3& s, const Corner3& t) { return key(s) < key(t); });
    n.first = static_cast<std::uint32_t>(nodes_.size());
    n.count = 0;
    nodes_[node] = n;
    nodes_.resize(nodes_.size() + 2);
    split(n.first, first, middle);
    split(n.first + 1, middle, last);
}

double Winding::at(const Vec3& p) const {
    double sum = 0;
    std::uint32_t stack[96], depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& n = nodes_[stack[--depth]];
        const Vec3 r = n.middle - p;
        const double d2 = dot(r, r);
        if (d2 > kFar * kFar * n.radius * n.radius) {
            sum += dot(n.dipole, r) / (d2 * std::sqrt(d2));
            continue;
        }
        if (n.count == 0 && !triangles_.empty()) {
            stack[depth++] = n.first + 1;
            stack[depth++] = n.first;
            continue;
        }
        for (std::uint32_t i = n.first; i < n.first + n.count; ++i)
            sum += solid_angle(triangles_[i].a - p, triangles_[i].b - p, triangles_[i].c - p);
    }
    return sum / (4 * std::numbers::pi);
}

} // namespace filum::mesh
