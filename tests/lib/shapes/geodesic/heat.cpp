// The heat method comes near the exact distance, for any mesh.
#include "geodesic/heat.hpp"
#include "geodesic/certificate.hpp"
#include "geodesic/exact.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>

namespace filum::geodesic {
namespace {

using surfaces::Vec2;

// Mean of |a - b| / b where b is beyond `from`.
double mean_error(const std::vector<double>& a, const std::vector<double>& b, double from) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (b[i] > from && std::isfinite(b[i])) {
            sum += std::abs(a[i] - b[i]) / b[i];
            count += 1;
        }
    return sum / count;
}

TEST(Heat, ComesNearOnASphere) {
    const Surface s = surfaces::bumpy_sphere(5, 0.002, 1);
    const Sources pole{{4}, {}};
    EXPECT_LT(mean_error(Heat(s, pole).distance(), exact(s, pole).distance, 0.1), 0.02);
}

TEST(Heat, IsExactNearTheSource) {
    const auto s = surfaces::sheet(40, 40, 60, 60, 4);
    const Sources cut{{}, surface::section(s.surface, {{1, 0.3, 0}, 17.2})};
    const auto near = Heat(s.surface, cut).distance();
    const auto truth = exact(s.surface, cut).distance;
    double edge = surface::mean_edge(s.surface);
    for (std::size_t v = 0; v < near.size(); ++v)
        if (truth[v] < 15 * edge) {
            EXPECT_NEAR(near[v], truth[v], 1e-9);
        }
    const auto paper = Heat(s.surface, cut, {.paper = true}).distance();
    EXPECT_LT(mean_error(near, truth, 1), 0.01);
    EXPECT_GT(mean_error(paper, truth, 1), 2 * mean_error(near, truth, 1));
}

TEST(Heat, ComponentsWithoutASourceAreInfinitelyFar) {
    const auto a = surfaces::sheet(10, 10, 12, 12, 4);
    auto v = a.surface.vertices;
    auto t = a.surface.triangles;
    const auto n = static_cast<std::uint32_t>(v.size());
    for (std::uint32_t i = 0; i < n; ++i) v.push_back(v[i] + Vec3{0, 0, 5});
    for (std::size_t i = 0, m = t.size(); i < m; ++i) t.push_back({t[i][0] + n, t[i][1] + n, t[i][2] + n});
    const Surface s = surfaces::make(v, t);
    for (const bool paper : {false, true}) {
        const auto d = Heat(s, {{5}, {}}, {.paper = paper}).distance();
        EXPECT_EQ(d[5], 0);
        for (std::uint32_t i = 0; i < n; ++i) {
            EXPECT_TRUE(std::isfinite(d[i]));
            EXPECT_TRUE(std::isinf(d[n + i]));
        }
    }
}

TEST(Heat, SurvivesSlivers) {
    const auto base = surfaces::sheet(20, 10, 40, 20, 2);
    std::vector<Vec3> v = base.surface.vertices;
    std::vector<mesh::Triangle> t;
    for (const auto& [a, b, c] : base.surface.triangles) {
        const auto m = static_cast<std::uint32_t>(v.size());
        v.push_back(0.98 * v[a] + 0.01 * v[b] + 0.01 * v[c]);
        t.insert(t.end(), {{a, b, m}, {b, c, m}, {c, a, m}});
    }
    const Surface s = surfaces::make(v, t);
    const Sources from{{10}, {}};
    EXPECT_LT(mean_error(Heat(s, from).distance(), exact(s, from).distance, 1), 0.03);
}

TEST(Heat, IsRaisedWhereItWouldFade) {
    // a strip whose diagonal is no measure of how long it is: folded like an accordion
    const auto lift = [](Vec2 p) {
        const double turn = std::fmod(p.x, 2.0);
        return Vec3{0.002 * p.x, p.y, turn < 1 ? turn : 2 - turn};
    };
    const auto s = surfaces::sheet(400, 0.2, 4000, 2, 1, lift);
    Heat heat(s.surface, {{0}, {}});
    const auto d = heat.distance();
    EXPECT_GE(heat.raised(), 1);
    const auto truth = exact(s.surface, {{0}, {}}).distance;
    EXPECT_LT(mean_error(d, truth, 1), 0.05);
}

TEST(Heat, TheCertificateTellsHowFarOffItIs) {
    const Surface s = surfaces::bumpy_sphere(5, 0, 1);
    const Sources sources{{0}, {}};
    const auto truth = exact(s, sources).distance;
    auto distance = truth;
    const DistanceError none = distance_error(truth, distance);
    EXPECT_EQ(none.largest, 0);
    EXPECT_GT(none.vertices, s.vertices.size() * 9 / 10);
    const DistanceError near = distance_error(exact_distances(s, sources, 1e9, 20'000).distance, distance);
    EXPECT_GT(near.vertices, 100U);
    EXPECT_LT(near.known, 0.8 * none.known);
    for (std::size_t v = 0; v < distance.size(); ++v) distance[v] *= v % 200 == 3 ? 1.5 : 1.1;
    const DistanceError much = distance_error(truth, distance);
    EXPECT_NEAR(much.p99, 0.1, 1e-9);
    EXPECT_NEAR(much.largest, 0.5, 1e-9);
    EXPECT_NEAR(much.mean, 0.102, 0.001);
}

} // namespace
} // namespace filum::geodesic
