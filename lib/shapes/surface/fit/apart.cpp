#include "surface/fit/apart.hpp"

#include "parallel/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surface::fit {

namespace {

constexpr std::size_t kTrianglesAtOnce = 1024; // triangles per task
constexpr double kMostPieces = 100;            // most sample points per side

// Calls visit(point) for the sample points of a triangle; points of a side only for the first of its half-edges.
template <class Visit>
void each_point(const Surface& s, std::uint32_t t, double step, const Visit& visit) {
    Vec3 middle;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const Vec3 &a = s.vertices[s.tail(h)], &b = s.vertices[s.head(h)];
        middle = middle + 1.0 / 3 * a;
        if (s.outgoing[s.tail(h)] == h) visit(a);
        if (s.twin[h] != kNone && s.twin[h] < h) continue;
        const double pieces = std::clamp(std::ceil(distance(a, b) / step), 1.0, kMostPieces);
        for (double k = 1; k < pieces; ++k) visit(a + k / pieces * (b - a));
    }
    visit(middle);
}

} // namespace

std::vector<Deviation> deviations(const Surface& from, const curve::Locator& to, double step) {
    std::vector<Deviation> out(from.triangles.size());
    parallel::for_chunks(out.size(), kTrianglesAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
            each_point(from, t, step, [&](const Vec3& p) {
                const curve::Place q = to.nearest(p);
                if (const double far = distance(p, q.point); far > out[t].far) out[t] = {far, p, q.triangle};
            });
    });
    return out;
}

} // namespace filum::surface::fit
