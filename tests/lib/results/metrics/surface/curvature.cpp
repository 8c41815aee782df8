// Curvature of circles on plane, cylinder and sphere, for any points on them; the paper's angles.
#include "metrics/surface/curvature.hpp"
#include "geodesic/isolines.hpp"
#include "geodesic/lines.hpp"
#include "metrics/surface/ground.hpp"
#include "paths.hpp"

#include <gtest/gtest.h>

namespace filum::metrics::surface {
namespace {

using paths::arc;
using paths::lifted;
using paths::Vec2;

using std::numbers::pi;

// Ways between points from 0.01 to 0.49 mm.
struct Uneven {
    std::mt19937 random{5};
    double operator()() { return 0.01 + 0.48 * (static_cast<double>(random()) / 4294967296.0); }
};

Fibre chain(const std::vector<Vec3>& points) { return paths::fibres({paths::span(points)}).all.at(0); }

Bends on(const Fibre& c, const std::function<Vec3(const Vec3&)>& normal, double step = 0.25) {
    std::vector<Vec3> normals;
    for (const Vec3& p : c.points) normals.push_back(normal(p));
    return bends(c, normals, step);
}

Vec3 up(const Vec3&) { return {0, 0, 1}; }

TEST(Curvature, CircleOfUnevenPoints) {
    const auto c = chain(lifted(arc({0, 0}, 2.4, 0, 2 * pi, Uneven{}), [](Vec2 p) { return Vec3{p.x, p.y, 0}; }));
    const Bends b = on(c, up);
    ASSERT_GT(b.places.size(), 50);
    for (const Bend& p : b.places) {
        EXPECT_NEAR(p.geodesic, 1 / 2.4, 0.01 / 2.4);
        EXPECT_EQ(p.normal, 0);
    }
    auto back = c.points;
    std::reverse(back.begin(), back.end());
    EXPECT_NEAR(on(chain(back), up).places[10].geodesic, -1 / 2.4, 0.01 / 2.4);
}

TEST(Curvature, CirclesOfLatitudeOnASphere) {
    const double radius = 20;
    for (const double latitude : {0.0, 0.6, 1.2}) {
        const auto c = chain(lifted(arc({0, 0}, radius * std::cos(latitude), 0, 6, Uneven{}), [&](Vec2 p) {
            return Vec3{p.x, p.y, radius * std::sin(latitude)};
        }));
        for (const Bend& p : on(c, [&](const Vec3& v) { return 1 / radius * v; }).places) {
            EXPECT_NEAR(p.geodesic, std::tan(latitude) / radius, 0.002) << latitude;
            EXPECT_NEAR(p.normal, -1 / radius, 0.002) << latitude;
        }
    }
}

TEST(Curvature, HelicesOnACylinder) {
    const double radius = 10;
    for (const double pitch : {0.0, 0.5, 1.5}) { // angle to the circles
        std::vector<Vec3> points;
        Uneven way;
        for (double s = 0; s < 40; s += way()) {
            const double a = s * std::cos(pitch) / radius;
            points.push_back({radius * std::cos(a), radius * std::sin(a), s * std::sin(pitch)});
        }
        const auto b = on(chain(points), [&](const Vec3& v) { return Vec3{v.x / radius, v.y / radius, 0}; });
        for (const Bend& p : b.places) {
            EXPECT_NEAR(p.geodesic, 0, 0.002);
            EXPECT_NEAR(p.normal, -std::cos(pitch) * std::cos(pitch) / radius, 0.002);
        }
    }
}

// Points where the circles of distance cross the sides of triangles: as uneven as they come.
TEST(Curvature, IsolinesOfTrianglesOnASphereCap) {
    const double big = 15;
    const auto cap = surfaces::sheet(12, 12, 24, 24, 3, [&](Vec2 p) {
        const double x = p.x - 6, y = p.y - 6;
        return Vec3{x, y, std::sqrt(big * big - x * x - y * y)};
    });
    const auto pole = filum::surface::nearest(cap.surface, {0, 0, big});
    filum::surface::Sources sources;
    sources.segments.push_back(pole);
    const auto field = geodesic::exact(cap.surface, sources);
    const double level = 3;
    const auto lines = geodesic::isolines(cap.surface, field, std::span(&level, 1));
    ASSERT_EQ(lines.size(), 1);
    auto points = lines[0].points;
    points.push_back(points.front());
    const Ground ground(cap.surface, 1);
    const Fibres f = paths::fibres({paths::span(points)});
    const Bends b = bends(f.all[0], feet(f, ground, 1).normals[0], 0.25);
    std::vector<Weighted> geodesic;
    for (const Bend& p : b.places) {
        geodesic.push_back({p.geodesic, p.length});
        EXPECT_NEAR(p.normal, -1 / big, 0.03);
    }
    const double truth = 1 / (big * std::tan(level / big));
    EXPECT_NEAR(std::abs(quantile(geodesic, 0.5)), truth, 0.02 * truth);
    EXPECT_NEAR(std::abs(quantile(geodesic, 0.05)), truth, 0.15 * truth);
    EXPECT_NEAR(std::abs(quantile(geodesic, 0.95)), truth, 0.15 * truth);
}

TEST(Curvature, ACornerCountsAsAnArcOfTwoSteps) {
    const Bends b = on(chain({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}}), up);
    double most = 0, all = 0;
    for (const Bend& p : b.places) {
        most = std::max(most, p.geodesic);
        all += p.geodesic * p.length;
    }
    EXPECT_NEAR(most, pi / 2 / 0.5, 0.25);
    EXPECT_NEAR(all, pi / 2, 1e-2);
}

// What would make curvature without bounds: points as good as one, and fibres as good as none.
TEST(Curvature, OfPointsTooNearToTell) {
    const auto points = lifted(arc({0, 0}, 3, 0, 4, [] { return 0.2; }), [](Vec2 p) { return Vec3{p.x, p.y, 0}; });
    std::mt19937 random(2);
    const auto noise = [&] { return 2e-7 * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
    std::vector<Vec3> doubled;
    for (const Vec3& p : points) {
        doubled.push_back(p);
        for (int i = 0; i < 2; ++i) doubled.push_back(p + Vec3{noise(), noise(), 0});
    }
    for (const Bend& b : on(chain(doubled), up).places) EXPECT_NEAR(b.geodesic, 1.0 / 3, 0.01);
    for (const Bend& b : on(chain({{0, 0, 0}, {1e-6, 0, 0}, {1e-6, 1e-6, 0}}), up).places)
        EXPECT_LE(std::abs(b.geodesic), pi / 2 / 0.25);
}

TEST(Curvature, TurnsAreCounted) {
    const auto rows = chain(lifted(paths::zigzag(0, 30, 0, 1, 7), [](Vec2 p) { return Vec3{p.x, p.y, 0}; }));
    EXPECT_EQ(on(rows, up).turns, 6);
    const auto ring = chain(lifted(arc({0, 0}, 10, 0, 6, [] { return 0.1; }), [](Vec2 p) {
        return Vec3{p.x, p.y, 0};
    }));
    EXPECT_EQ(on(ring, up).turns, 0);
}

// What the paper's figure makes of one and the same turn of radius 0.5 (notes on its definition): 106, 57 and 29
// degrees by resampling at 1, 0.5 and 0.25 mm.
TEST(PaperAngle, DependsOnTheResampling) {
    const auto f = paths::fibres({paths::span(lifted(paths::zigzag(0, 40.2, 0, 1, 60), [](Vec2 p) {
        return Vec3{p.x, p.y, 0};
    }))});
    EXPECT_NEAR(paper_angle(f, 1) * 180 / pi, 106, 3);
    EXPECT_NEAR(paper_angle(f, 0.5) * 180 / pi, 57.3, 0.5);
    EXPECT_NEAR(paper_angle(f, 0.25) * 180 / pi, 28.6, 0.3);
}

TEST(PaperAngle, EndsAreZero) {
    EXPECT_EQ(paper_angle(paths::fibres({paths::span({{0, 0, 0}, {1, 0, 0}}), paths::span({{0, 5, 0}, {0, 6, 0}})}), 1),
              0);
}

} // namespace
} // namespace filum::metrics::surface
