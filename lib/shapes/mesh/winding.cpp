#include "mesh/winding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::mesh {

namespace {

constexpr std::uint32_t kLeaf = 8;  // most triangles of a leaf
constexpr double kFar = 3;          // in radii of a node: from this distance on, a node counts as one dipole
constexpr double kSmall = 0x1p-500; // products of directions are enlarged below this

// Adds signed solid angles without an arc tangent for each. Half of the solid angle of a triangle is the angle of a
// complex number, in [-pi, pi] (Van Oosterom and Strackee 1983). The product of those numbers has the sum of the
// angles, less whole turns. A turn is complete where two angles of one sign have a product of the other sign. Rounding
// cannot miscount: terms of the imaginary part cancel only near pi, where the turn and the final angle use the same
// sign bit.
class SolidAngles {
  public:
    // Adds the triangle a, b, c, relative to the point. A triangle with a corner on the point adds nothing.
    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const double la = norm(a), lb = norm(b), lc = norm(c);
        const double along = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
        const double across = dot(a, cross(b, c));
        const double size = std::abs(along) + std::abs(across);
        if (!(size > 0)) return;
        const double x = along / size, y = across / size;
        const double re = re_ * x - im_ * y, im = re_ * y + im_ * x;
        const int back = std::signbit(y) ? 1 : 0, was = std::signbit(im_) ? 1 : 0, is = std::signbit(im) ? 1 : 0;
        turns_ += (1 - 2 * back) * ((1 ^ back ^ was) & (back ^ is));
        const double scale = std::abs(re) + std::abs(im) < kSmall ? 1 / kSmall : 1; // each factor is at least 1/2
        re_ = scale * re;
        im_ = scale * im;
    }

    // The sum, sr.
    [[nodiscard]] double sum() const { return 2 * (2 * std::numbers::pi * turns_ + std::atan2(im_, re_)); }

  private:
    double re_ = 1, im_ = 0;
    int turns_ = 0;
};

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
    double far = 0; // sr of distant triangles
    SolidAngles near;
    std::uint32_t stack[96], depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& n = nodes_[stack[--depth]];
        const Vec3 r = n.middle - p;
        const double d2 = dot(r, r);
        if (d2 > kFar * kFar * n.radius * n.radius) {
            far += dot(n.dipole, r) / (d2 * std::sqrt(d2));
            continue;
        }
        if (n.count == 0 && !triangles_.empty()) {
            stack[depth++] = n.first + 1;
            stack[depth++] = n.first;
            continue;
        }
        for (std::uint32_t i = n.first; i < n.first + n.count; ++i)
            near.add(triangles_[i].a - p, triangles_[i].b - p, triangles_[i].c - p);
    }
    return (far + near.sum()) / (4 * std::numbers::pi);
}

} // namespace filum::mesh
