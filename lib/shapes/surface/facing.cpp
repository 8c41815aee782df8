#include "surface/facing.hpp"

#include <cmath>

namespace filum::surface {

namespace {

constexpr double kHollow = 0.005; // |volume| over area^1.5 (a sphere has 0.094), below which a surface counts as flat
constexpr double kUp = 0.1;       // mean z of the normals above which a surface faces up
constexpr double kDown = -0.5;    // mean z of the normals below which a surface faces down
// Opening over area, above which a surface may be a concave part of a larger one, such as a fillet: 0.64 for half a
// cylinder, 0.7 for an arc of 160 degrees, 0.9 for a quarter, 0.5 for half a sphere.
constexpr double kOpen = 0.7;

// Sums over the triangles of a component.
struct Sums {
    double volume = 0; // six times the volume, with lids on all rims
    double area = 0;   // twice the area
    Vec3 normals;      // twice the area times the normal: as large as the opening that its rims leave
    std::size_t rims = 0;
    std::uint32_t first = kNone; // its first vertex, the origin for volumes
};

std::vector<Sums> sums(const Surface& s) {
    std::vector<Sums> out(s.components);
    const auto add = [&](Sums& to, const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 o = s.vertices[to.first];
        to.volume += dot(a - o, cross(b - o, c - o));
    };
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        Sums& to = out[s.component[t]];
        const auto& [i, j, k] = s.triangles[t];
        if (to.first == kNone) to.first = i;
        const Vec3 &a = s.vertices[i], &b = s.vertices[j], &c = s.vertices[k];
        const Vec3 n = cross(b - a, c - a);
        to.area += norm(n);
        to.normals = to.normals + n;
        add(to, a, b, c);
    }
    for (const Rim& rim : s.rims) {
        Sums& to = out[rim.component];
        ++to.rims;
        Vec3 middle;
        for (const std::uint32_t h : rim.sides) middle = middle + s.vertices[s.tail(h)];
        middle = 1.0 / static_cast<double>(rim.sides.size()) * middle;
        for (const std::uint32_t h : rim.sides) add(to, s.vertices[s.head(h)], s.vertices[s.tail(h)], middle);
    }
    return out;
}

bool faces_inwards(const Sums& c) {
    if (c.rims == 0) return c.volume < 0;
    const double hollow = c.volume / 6 / std::pow(c.area / 2, 1.5), up = c.normals.z / c.area;
    if (up < kDown && hollow < kHollow) return true;
    return hollow < -kHollow && up < kUp && norm(c.normals) < kOpen * c.area;
}

} // namespace

InwardArea inward(const Surface& s) {
    InwardArea out;
    for (const Sums& c : sums(s)) {
        out.which.push_back(faces_inwards(c) ? 1 : 0);
        if (out.which.back() == 0) continue;
        if (out.components++ == 0) out.place = s.vertices[c.first];
        out.area += c.area / 2;
    }
    return out;
}

Surface flipped(const Surface& s, std::span<const char> which) {
    const auto other = [&](std::uint32_t h) {
        return h == kNone || which[s.component[h / 3]] == 0 ? h : 3 * (h / 3) + 2 - h % 3;
    };
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> twin(s.twin.size());
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        triangles.push_back(which[s.component[t]] != 0 ? Triangle{a, c, b} : Triangle{a, b, c});
    }
    for (std::uint32_t h = 0; h < twin.size(); ++h) twin[other(h)] = other(s.twin[h]);
    return assemble(s.vertices, std::move(triangles), std::move(twin));
}

Surface flipped(const Surface& s) {
    const InwardArea in = inward(s);
    if (in.components > 0 && in.components < s.components) return flipped(s, in.which);
    return flipped(s, std::vector<char>(s.components, 1));
}

} // namespace filum::surface
