#include "render/surface_beads.hpp"

#include "render/camera.hpp"
#include "render/sampling.hpp"
#include "render/simplify.hpp"
#include "surface/curve/locate.hpp"

#include <algorithm>
#include <cmath>

namespace filum::render {

namespace {

using geom::Vec3;

constexpr double kSimplify = 0.004; // tolerance of visible_points, as a share of the bead width
constexpr double kMostReach = 8;    // largest reach in half widths, limited by the memory of the grid of strokes
// Length in mm added along the path for a travel, so that beads before and after it are no neighbours.
constexpr double kBreak = 1e6;
constexpr std::uint32_t kSamples = 1 << 17, kSeed = 7;

std::vector<Stroke> beads(const Scene& scene, const Tint& tint) {
    std::vector<Stroke> out;
    double before = 0;
    for (std::size_t k = 0; k < scene.spans.size(); ++k) {
        const auto& s = scene.spans[k];
        if (!toolpath::extrudes(s.role)) {
            before += kBreak;
            continue;
        }
        const auto kept = visible_points(s, kSimplify * s.width_at(0));
        double along = 0;
        for (std::size_t m = 0; m + 1 < kept.size(); ++m) {
            const auto i = kept[m], j = kept[m + 1];
            const double a = kFat * s.width_at(i) / 2, b = kFat * s.width_at(j) / 2, half = std::max(a, b);
            const double reach = std::min(half + s.layer * s.height_at(i), kMostReach * half);
            const Vec3 up = s.normals.empty() ? Vec3{} : unit(s.normals[i] + s.normals[j]);
            out.push_back(
                {s.points[i], s.points[j], up, a, b, reach, before + along, s.layer, colour(tint, scene, k, i, along)});
            for (auto p = i; p < j; ++p) along += geom::distance(s.points[p], s.points[p + 1]);
        }
        before += along;
    }
    return out;
}

// True if both ends and the middle lie within reach of triangles that face like the stroke, or opposite to it if
// `against`.
bool lies_on(const surface::curve::Locator& locator, const Stroke& s, bool against) {
    const Vec3 n = against ? -1.0 * s.normal : s.normal;
    for (const Vec3 p : {s.a, 0.5 * (s.a + s.b), s.b}) {
        const auto place = locator.nearest(p, n);
        if (place.triangle == surface::kNone || geom::distance(place.point, p) > s.reach) return false;
    }
    return true;
}

} // namespace

SurfaceBeads surface_beads(const Scene& scene, const Tint& tint) {
    SurfaceBeads out;
    auto all = beads(scene, tint);
    if (all.empty()) return out;
    const auto& surface = scene.sheet->surface;
    const surface::curve::Locator locator(surface);
    double front = 0, back = 0; // mm
    for (Stroke& s : all) {
        if (s.normal == Vec3{}) s.normal = surface::normal(surface, locator.nearest(0.5 * (s.a + s.b)).triangle);
        const double length = geom::distance(s.a, s.b);
        const bool on_front = lies_on(locator, s, false), on_back = !on_front && lies_on(locator, s, true);
        (on_front ? front : back) += on_front || on_back ? length : 0;
        if (!on_front && !on_back) out.loose.push_back(s);
    }
    out.behind = back > front;
    out.beads = Strokes(std::move(all));
    return out;
}

double uncovered(const surface::Surface& s, const SurfaceBeads& laid) {
    double total = 0;
    std::vector<double> before;
    for (const auto& t : s.triangles) {
        before.push_back(total);
        total += norm(cross(s.vertices[t[1]] - s.vertices[t[0]], s.vertices[t[2]] - s.vertices[t[0]]));
    }
    std::uint32_t bare = 0, t = 0;
    for (std::uint32_t k = 0; k < kSamples; ++k) {
        const double at = (k + 0.5) / kSamples * total;
        while (t + 1 < before.size() && before[t + 1] <= at) ++t;
        const auto [a, b, c] = s.triangles[t];
        Square q = spread(kSeed, k);
        if (q.u + q.v > 1) q = {1 - q.u, 1 - q.v};
        const Vec3 p = s.vertices[a] + q.u * (s.vertices[b] - s.vertices[a]) + q.v * (s.vertices[c] - s.vertices[a]);
        const Vec3 n = surface::normal(s, t);
        const Cover cover = laid.beads.at(p, laid.behind ? -1.0 * n : n);
        bare += cover.stroke == nullptr || cover.off * kFat > 1 ? 1 : 0;
    }
    return static_cast<double>(bare) / kSamples;
}

} // namespace filum::render
