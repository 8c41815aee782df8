#include "app/modifier/painted.hpp"

#include "app/modifier/modifier.hpp"

#include "polygon/clip.hpp"

#include <algorithm>

namespace filum::app::modifier {

namespace {

using geom::Vec3;

// The normal of a triangle; its length is twice the area.
Vec3 normal(const mesh::Mesh& m, const mesh::Triangle& t) {
    return cross(m.vertices[t[1]] - m.vertices[t[0]], m.vertices[t[2]] - m.vertices[t[0]]);
}

// The part of a convex face above (side 1) or below (side -1) the height z.
std::vector<Vec3> beyond(const std::vector<Vec3>& face, double z, double side) {
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3 a = face[i], b = face[(i + 1) % face.size()];
        const double u = side * (a.z - z), v = side * (b.z - z);
        if (u >= 0) out.push_back(a);
        if ((u > 0 && v < 0) || (u < 0 && v > 0)) out.push_back(a + (u / (u - v)) * (b - a));
    }
    return out;
}

} // namespace

std::vector<polygon::Loops> seen_from_below(const mesh::Mesh& faces, std::span<const filum::slice::Level> levels,
                                            std::span<const std::uint32_t> layer) {
    std::vector<polygon::Loops> out(layer.empty() ? 0 : layer.back() + 1);
    for (const mesh::Triangle& t : faces.triangles) {
        if (normal(faces, t).z >= 0) continue;
        const std::vector<Vec3> face{faces.vertices[t[0]], faces.vertices[t[1]], faces.vertices[t[2]]};
        const auto [low, high] = std::minmax({face[0].z, face[1].z, face[2].z});
        // The search begins at the first level whose plane is not below the face.
        auto at = std::ranges::lower_bound(levels, low - filum::slice::kLift, {}, &filum::slice::Level::plane);
        for (; at != levels.end(); ++at) {
            const double from = at == levels.begin() ? low : std::prev(at)->plane;
            if (from > high + filum::slice::kLift) break;
            const auto within =
                beyond(beyond(face, from - filum::slice::kLift, 1), at->plane + filum::slice::kLift, -1);
            if (within.size() < 3) continue;
            polygon::Loops& to = out[layer[static_cast<std::size_t>(at - levels.begin())]];
            for (std::size_t i = within.size(); i-- > 0;)
                to.points.push_back(within[i].xy()); // reversed, so that it is counter-clockwise seen from above
            to.close();
        }
    }
    for (polygon::Loops& loops : out)
        if (!loops.empty()) loops = polygon::unite(loops);
    return out;
}

std::vector<geom::Segment> lines_at(const mesh::Mesh& faces, double z) {
    std::vector<geom::Segment> out;
    for (const mesh::Triangle& t : faces.triangles) {
        std::vector<geom::Vec2> ends;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 a = faces.vertices[t[k]], b = faces.vertices[t[(k + 1) % 3]];
            if ((a.z > z) != (b.z > z)) ends.push_back(geom::lerp(a.xy(), b.xy(), (z - a.z) / (b.z - a.z)));
        }
        if (ends.size() == 2) out.push_back({ends[0], ends[1]});
    }
    return out;
}

double area_facing_down(const mesh::Mesh& faces) {
    double out = 0;
    for (const mesh::Triangle& t : faces.triangles)
        if (const Vec3 n = normal(faces, t); n.z < 0) out += geom::norm(n) / 2;
    return out;
}

} // namespace filum::app::modifier
