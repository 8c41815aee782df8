// Lines drawn onto surfaces hang together, stay on them and go where they should.
#include "surface/trace.hpp"
#include "base/error.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::surface {
namespace {

Surface grid(int n, double (*lift)(double, double)) {
    mesh::Mesh m;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) m.vertices.push_back({double(i), double(j), lift(i, j)});
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            if (i != 7 || j != 7)
                m.triangles.insert(m.triangles.end(), {{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                                       {at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    Notes notes;
    return connect(m, notes);
}

TEST(Trace, LinesAreWholeAndOnTheSurface) {
    const Surface flat = grid(10, [](double, double) { return 0.0; });
    const Surface bent = grid(10, [](double x, double y) { return 0.1 * x * x - 0.05 * x * y; });
    std::mt19937 random(1);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int round = 0; round < 200; ++round)
        for (const Surface* s : {&flat, &bent}) {
            std::vector<Vec3> points;
            for (int k = 0; k < 4; ++k) {                                // some on vertices and edges
                const double x = 1 + 5.9 * unit(), y = 1 + 8.5 * unit(); // clear of the rim
                const Vec3 p{k == 1 ? std::floor(x) : x, k < 3 ? std::floor(y) : y, s == &flat ? 0.0 : 2.0};
                points.push_back(nearest(*s, p).a);
                if (points.back().x > 7) points.back() = nearest(*s, {3, 3, 0}).a; // clear of the hole
            }
            const Trace t = trace(*s, points);
            EXPECT_LT(t.off, 1e-12);
            double length = 0, direct = 0;
            for (std::size_t i = 0; i < t.segments.size(); ++i) {
                const Segment& e = t.segments[i];
                length += distance(e.a, e.b);
                if (i > 0) {
                    EXPECT_EQ(e.a, t.segments[i - 1].b);
                }
                const Vec3 n = normal(*s, e.triangle), v = s->vertices[s->triangles[e.triangle][0]];
                EXPECT_NEAR(dot(e.a - v, n), 0, 1e-9);
                EXPECT_NEAR(dot(e.b - v, n), 0, 1e-9);
            }
            for (std::size_t k = 1; k < points.size(); ++k) direct += distance(points[k - 1], points[k]);
            EXPECT_NEAR(distance(t.segments.front().a, points.front()), 0, 1e-6);
            EXPECT_NEAR(distance(t.segments.back().b, points.back()), 0, 1e-6);
            EXPECT_GT(length, direct - 1e-5);
            EXPECT_LT(length, s == &flat ? direct + 1e-5 : 2 * direct + 1);
        }
}

TEST(Trace, OnePointIsAPoint) {
    const Surface s = grid(4, [](double, double) { return 0.0; });
    const Vec3 p[] = {{1.3, 1.2, 0.5}};
    const Trace t = trace(s, p);
    ASSERT_EQ(t.segments.size(), 1U);
    EXPECT_EQ(t.segments[0].a, t.segments[0].b);
    EXPECT_NEAR(t.off, 0.5, 1e-9);
}

TEST(Trace, SaysWhereTheSurfaceEnds) {
    const Surface s = grid(10, [](double, double) { return 0.0; });
    const Vec3 across[] = {{1, 7.5, 0}, {6, 7.5, 0}, {9, 7.5, 0}}; // over the missing cell
    try {
        trace(s, across);
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        EXPECT_NE(std::string(e.what()).find("points 2 and 3"), std::string::npos) << e.what();
    }
}

} // namespace
} // namespace filum::surface
