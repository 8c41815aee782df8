#include "surfpath/field/rings.hpp"

#include "geodesic/exact.hpp"
#include "geodesic/isolines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::surfpath::field {

namespace {

// The lines from which rings are measured: all rims, and the sources of components without a rim.
surface::Sources begins(const surface::Sheet& sheet) {
    const Surface& s = sheet.surface;
    std::vector<char> rimmed(s.components, 0);
    for (const auto& rim : s.rims) rimmed[rim.component] = 1;
    surface::Sources out = surface::rim_sources(s);
    for (const auto& g : sheet.sources.segments)
        if (rimmed[s.component[g.triangle]] == 0) out.segments.push_back(g);
    for (const std::uint32_t v : sheet.sources.vertices)
        if (rimmed[s.component[s.outgoing[v] / 3]] == 0) out.vertices.push_back(v);
    return out;
}

} // namespace

RingField ring_field(const surface::Sheet& sheet, const Cells& cells) {
    const Surface& s = sheet.surface;
    const std::size_t n = s.vertices.size();
    RingField out{std::vector<double>(n, std::numeric_limits<double>::infinity()), std::vector<Complex>(n),
                  std::vector<Vec3>(n)};
    const surface::Sources begin = begins(sheet);
    if (begin.empty()) return out;
    out.distance = geodesic::exact_distances(s, begin).distance;
    std::vector<double> area(n, 0);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& c = s.triangles[t];
        const Vec3 normal = surface::normal(s, t);
        Vec3 along; // the gradient of the distance, turned by a right angle
        for (std::size_t k = 0; k < 3; ++k)
            along = along + out.distance[c[k]] * (s.vertices[c[(k + 2) % 3]] - s.vertices[c[(k + 1) % 3]]);
        if (!(norm(along) > 0) || !std::isfinite(norm(along))) continue;
        const double a = surface::area(s, t);
        const Vec3 unit = 1 / norm(along) * along;
        const Complex z = surface::directions::doubled(unit, normal);
        for (const std::uint32_t v : c) {
            out.z[v] += a * z * surface::directions::transport(normal, cells.normal[v]);
            out.along[v] = out.along[v] + a * surface::directions::turned(unit, normal, cells.normal[v]);
            area[v] += a;
        }
    }
    for (std::size_t v = 0; v < n; ++v)
        if (area[v] > 0) out.z[v] /= area[v];
    return out;
}

std::vector<Complex> phase(const RingField& rings, std::span<const Vec3> along, double spacing) {
    std::vector<Complex> out;
    for (std::size_t v = 0; v < along.size(); ++v) {
        const double angle = std::numbers::pi * rings.distance[v] / spacing;
        const bool same = dot(along[v], rings.along[v]) >= 0;
        out.push_back(std::isfinite(angle) ? std::polar(1.0, same ? angle : -angle) : Complex{});
    }
    return out;
}

std::vector<surface::curve::Line> whole_rings(const surface::Sheet& sheet, double spacing) {
    const surface::Sources begin = begins(sheet);
    if (begin.empty()) return {};
    const auto field = geodesic::exact(sheet.surface, begin);
    double farthest = 0;
    for (const double d : field.distance)
        if (std::isfinite(d)) farthest = std::max(farthest, d);
    std::vector<double> levels;
    for (double level = spacing / 2; level < farthest; level += spacing) levels.push_back(level);
    std::vector<surface::curve::Line> out;
    for (const auto& isoline : geodesic::isolines(sheet.surface, field, levels)) {
        auto line = surface::curve::line(isoline);
        if (line.size() >= 3) out.push_back(std::move(line));
    }
    return out;
}

} // namespace filum::surfpath::field
