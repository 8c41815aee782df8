#include "surface/fit/apart.hpp"

#include "parallel/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surface::fit {

namespace {

constexpr std::size_t kPointsAtOnce = 1024; // points, or triangles, of a piece of work
constexpr double kMostPieces = 100;         // of a side

// Calls visit(point) for the points of a triangle, those of a side for the first of its two half-edges only.
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

std::vector<curve::Place> nearest(const curve::Locator& locator, std::span<const Vec3> points) {
    std::vector<curve::Place> out(points.size());
    parallel::for_chunks(points.size(), kPointsAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) out[i] = locator.nearest(points[i]);
    });
    return out;
}

Apart farthest(const Surface& from, const curve::Locator& to, double step) {
    const std::size_t n = from.triangles.size();
    std::vector<Apart> found((n + kPointsAtOnce - 1) / kPointsAtOnce); // of each piece
    parallel::for_chunks(n, kPointsAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        Apart& most = found[begin / kPointsAtOnce];
        for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
            each_point(from, t, step, [&](const Vec3& p) {
                if (const double far = distance(p, to.nearest(p).point); far > most.far) most = {far, p};
            });
    });
    Apart out;
    for (const Apart& a : found)
        if (a.far > out.far) out = a;
    return out;
}

} // namespace filum::surface::fit
