#include "mesh/polygons.hpp"

#include "mesh/ears.hpp"
#include "mesh/formats.hpp"

#include <cmath>
#include <numbers>

namespace filum::mesh {

namespace {

constexpr double kFolded = 1e-10; // twice the least area of a fan's triangle, as a fraction of the product of its sides

// The mean normal of a polygon (Newell), twice its area long.  Relative to the first corner, for precision.
Vec3 newell(const std::vector<Vec3>& at, std::span<const std::uint32_t> corners) {
    Vec3 out;
    const Vec3 o = at[corners[0]];
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) out = out + cross(at[corners[k]] - o, at[corners[k + 1]] - o);
    return out;
}

// True if no triangle of the fan from the first corner folds over, and together they span less than a full turn.
bool fan_fits(const std::vector<Vec3>& at, std::span<const std::uint32_t> corners, const Vec3& normal) {
    const Vec3 o = at[corners[0]];
    double round = 0;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        const Vec3 a = at[corners[k]] - o, b = at[corners[k + 1]] - o;
        const double area = dot(cross(a, b), normal);
        if (!(area > kFolded * norm(a) * norm(b))) return false;
        round += std::atan2(area, dot(a, b));
    }
    return round < 2 * std::numbers::pi;
}

// Indices of the polygon's corners, without corners that coincide exactly with the one before.
std::vector<std::uint32_t> distinct(const std::vector<Vec3>& at, std::span<const std::uint32_t> corners) {
    std::vector<std::uint32_t> out;
    for (std::uint32_t k = 0; k < corners.size(); ++k)
        if (out.empty() || !(at[corners[out.back()]] == at[corners[k]])) out.push_back(k);
    while (out.size() > 1 && at[corners[out.back()]] == at[corners[out.front()]]) out.pop_back();
    return out;
}

std::vector<geom::Vec2> seen_along(const Vec3& normal, const std::vector<Vec3>& at,
                                   std::span<const std::uint32_t> corners, std::span<const std::uint32_t> kept) {
    const Vec3 aside = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 x = geom::unit(cross(aside, normal), {}), y = cross(normal, x);
    std::vector<geom::Vec2> out;
    out.reserve(kept.size());
    for (const std::uint32_t k : kept) {
        const Vec3 p = at[corners[k]] - at[corners[0]];
        out.push_back({dot(p, x), dot(p, y)});
    }
    return out;
}

} // namespace

void Faces::add(std::span<const std::uint32_t> corners) {
    if (corners.size() > 3) {
        polygons_.push_back({triangles.size(), corners_.size(), corners.size()});
        corners_.insert(corners_.end(), corners.begin(), corners.end());
    }
    for (std::size_t k = 2; k < corners.size(); ++k) triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

void Faces::cut(const std::vector<Vec3>& vertices, Notes& notes) {
    Note crossed = note(NoteCode::face_crosses_itself);
    crossed.count = 0;
    for (const Polygon& p : polygons_) {
        const std::span corners(corners_.data() + p.first, p.corners);
        const Vec3 sum = newell(vertices, corners);
        if (!(norm(sum) > 0) || !std::isfinite(norm(sum))) continue; // the polygon has no plane to project it onto
        const Vec3 normal = 1 / norm(sum) * sum;
        if (fan_fits(vertices, corners, normal)) continue;
        const auto kept = distinct(vertices, corners);
        if (kept.size() < 3) continue;
        const Ears ears = cut_ears(seen_along(normal, vertices, corners, kept));
        for (std::size_t k = 0; k + 2 < corners.size(); ++k) {
            Triangle& t = triangles[p.triangle + k];
            t = {corners[0], corners[0], corners[0]}; // an empty triangle stands for a repeated corner; read() drops it
            if (k < ears.triangles.size())
                for (std::size_t i = 0; i < 3; ++i) t[i] = corners[kept[ears.triangles[k][i]]];
        }
        if (ears.sound) continue;
        if (crossed.count++ == 0) {
            crossed.x = vertices[corners[0]].x;
            crossed.y = vertices[corners[0]].y;
        }
        crossed.amount += norm(sum) / 2;
    }
    if (crossed.count > 0) notes.push_back(std::move(crossed));
}

} // namespace filum::mesh
