#include "choose/candidates.hpp"
#include "geodesic/exact.hpp"
#include "metrics/surface/load.hpp"

namespace filum::choose {

namespace {

// Gradient of the linear function with these values at the corners.
Vec3 slope(const Surface& s, std::uint32_t t, const std::vector<double>& value) {
    const auto [a, b, c] = s.triangles[t];
    const Vec3 u = s.vertices[b] - s.vertices[a], v = s.vertices[c] - s.vertices[a], n = cross(u, v);
    return 1 / dot(n, n) * cross((value[b] - value[a]) * v - (value[c] - value[a]) * u, n);
}

// Direction that field would follow at a vertex, on a triangle of normal `n`, of any length.
Vec3 followed_direction(const Seed& seed, const std::vector<Vec3>& pull, std::uint32_t v, const Vec3& n) {
    const Vec3 d = seed.kind == Seed::Kind::stress ? pull[v] : seed.a;
    return d - dot(d, n) / dot(n, n) * n;
}

} // namespace

double estimate(const Sheet& sheet, const std::vector<Vec3>& pull, const Candidate& candidate) {
    const Surface& s = sheet.surface;
    const auto loads = metrics::surface::load_cases(sheet);
    if (loads.empty()) return std::nan("");
    const bool planes = candidate.algorithm == surfpath::Algorithm::fexa && candidate.seed.kind == Seed::Kind::plane;
    const bool by_field = candidate.algorithm == surfpath::Algorithm::field;
    const auto from = sources(sheet, pull, candidate.seed);
    const auto distance = planes || by_field ? std::vector<double>{} : geodesic::exact_distances(s, from).distance;
    double along = 0, most = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& corners = s.triangles[t];
        const Vec3 a = s.vertices[corners[0]];
        const Vec3 n = cross(s.vertices[corners[1]] - a, s.vertices[corners[2]] - a);
        const Vec3 up = by_field ? Vec3{} : planes ? candidate.seed.plane.normal : slope(s, t, distance);
        for (const std::uint32_t v : corners) {
            const Vec3 way = by_field ? followed_direction(candidate.seed, pull, v, n)
                             : candidate.algorithm == surfpath::Algorithm::ortheo ? up
                                                                                  : cross(n, up);
            if (!(norm(way) > 0) || !std::isfinite(norm(way))) continue;
            const auto at = metrics::surface::pull(loads, v, 1 / norm(way) * way);
            along += norm(n) * at.along;
            most += norm(n) * at.most;
        }
    }
    return most > 0 ? along / most : std::nan("");
}

} // namespace filum::choose
