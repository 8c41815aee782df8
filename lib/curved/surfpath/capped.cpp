#include "surfpath/capped.hpp"

#include "surface/trace.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>

namespace filum::surfpath {

using geom::Vec3;
using surface::kNone;
using surface::Rim;
using surface::Surface;

namespace {

constexpr double kHole = 0.5; // largest length of a hole's rim, as a share of the outer rim's length

std::vector<const Rim*> holes(const Surface& s) {
    std::vector<double> outer(s.components, 0);
    for (const Rim& rim : s.rims)
        if (rim.outer) outer[rim.component] = surface::rim_length(s, rim);
    std::vector<const Rim*> out;
    for (const Rim& rim : s.rims)
        if (!rim.outer && surface::rim_length(s, rim) < kHole * outer[rim.component]) out.push_back(&rim);
    return out;
}

bool at_rim(const Surface& s, const Rim& rim, const Vec3& p) {
    return std::any_of(rim.sides.begin(), rim.sides.end(),
                       [&](std::uint32_t h) { return surface::distance_to_side(s, h, p) < rules::kSamePoint; });
}

} // namespace

Surface capped(const Surface& s) {
    auto vertices = s.vertices;
    auto triangles = s.triangles;
    auto twin = s.twin;
    for (const Rim* rim : holes(s)) {
        const auto middle = static_cast<std::uint32_t>(vertices.size());
        const auto n = static_cast<std::uint32_t>(rim->sides.size());
        const auto first = static_cast<std::uint32_t>(triangles.size());
        Vec3 sum;
        for (const std::uint32_t h : rim->sides) sum = sum + 1.0 / n * s.vertices[s.tail(h)];
        vertices.push_back(sum);
        // Triangle i contains side i in the opposite direction; its other two sides lead to the middle and back.
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t h = rim->sides[i], own = 3 * (first + i);
            triangles.push_back({s.head(h), s.tail(h), middle});
            twin.insert(twin.end(), {h, 3 * (first + (i + n - 1) % n) + 2, 3 * (first + (i + 1) % n) + 1});
            twin[h] = own;
        }
    }
    return surface::assemble(std::move(vertices), std::move(triangles), std::move(twin));
}

surface::Sources bridged(const Surface& s, const Surface& closed, const surface::Sources& seed) {
    surface::Sources out = seed;
    for (const Rim* rim : holes(s)) {
        std::vector<Vec3> ends;
        for (const auto& g : seed.segments)
            for (const Vec3& p : {g.a, g.b})
                if (at_rim(s, *rim, p) && std::none_of(ends.begin(), ends.end(), [&](const Vec3& q) {
                        return distance(p, q) < rules::kSamePoint;
                    }))
                    ends.push_back(p);
        if (ends.size() != 2) continue;
        const auto way = surface::trace(closed, ends);
        out.segments.insert(out.segments.end(), way.segments.begin(), way.segments.end());
    }
    return out;
}

} // namespace filum::surfpath
