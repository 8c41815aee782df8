// Paths of rings on surfaces whose answers are known: one stroke that meets itself piece by piece, stays on the
// surface, turns no tighter than it says, and covers what it can.
#include "surface/curve/walk.hpp"
#include "surfpath/geo_contour.hpp"
#include "surfpath/geo_fiso.hpp"
#include "surfpath/rings/ring.hpp"
#include "surfpath/surfpath.hpp"

#include "../../shapes/surface/grid.hpp"
#include "plans.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>

namespace filum::surfpath {

using namespace rings;
namespace {

using std::numbers::pi;

using Inside = std::function<bool(double, double)>;
using Lift = std::function<Vec3(double, double)>;

// The cells of about 0.8 mm of [0, a] x [0, b] that lie inside, put into space.
surface::Sheet patch(
    double a, double b, const Inside& inside, const Lift& lift = [](double x, double y) {
        return Vec3{x, y, 0};
    }) {
    Notes notes;
    auto mesh = surface::pierced_grid(
        a, b, static_cast<int>(std::round(a / 0.8)), static_cast<int>(std::round(b / 0.8)),
        [&](Vec2 p) { return lift(p.x, p.y); }, [&](Vec2 p) { return !inside(p.x, p.y); });
    return {surface::connect(std::move(mesh), notes), {}, {}};
}

bool everywhere(double, double) { return true; }

// The square [0, 2 r] x [0, 2 r] drawn out to a disc about (r, r).
Lift disc(double r, const std::function<double(double)>& height) {
    return [=](double x, double y) -> Vec3 {
        const double u = x / r - 1, v = y / r - 1;
        const double p = u * std::sqrt(1 - v * v / 2), q = v * std::sqrt(1 - u * u / 2);
        return {r + r * p, r + r * q, height(r * std::hypot(p, q))};
    };
}

Line whole(const Stroke& stroke) {
    Line out;
    for (const Section& piece : stroke.sections) surface::curve::append(out, piece.line);
    return out;
}

// The share of the length outside of hairpins that turns along the surface by more than 0.45 / mm.
double tight(const Surface& s, const Plan& plan) {
    double out = 0, all = 0;
    for (const Stroke& stroke : plan.strokes) {
        all += surface::curve::length(whole(stroke));
        for (const Section& piece : stroke.sections) {
            if (piece.hairpin || surface::curve::length(piece.line) < 1) continue;
            const Line line = surface::curve::resampled(piece.line, 0.5);
            for (std::size_t i = 1; i + 1 < line.size(); ++i) {
                const Vec3 a = line[i] - line[i - 1], b = line[i + 1] - line[i];
                const Vec3 n = surface::normal(s, line.places[i].triangle);
                const double turn = std::atan2(dot(cross(a, b), n), dot(a, b) - dot(a, n) * dot(b, n));
                if (std::abs(turn) > 0.45 * 0.5) out += 0.5;
            }
        }
    }
    return out / all;
}

struct Case {
    const char* name;
    std::function<surface::Sheet()> make;
    double covered;
};

class Rings : public testing::TestWithParam<Case> {};

Plan finished(const surface::Sheet& sheet, Algorithm algorithm) {
    const Options o{.algorithm = algorithm};
    Plan out = plan_paths(sheet, o);
    finish(sheet.surface, out, o);
    return out;
}

void check(const surface::Sheet& sheet, const Plan& plan, double least) {
    ASSERT_EQ(plan.strokes.size(), 1U);
    const auto& sections = plan.strokes[0].sections;
    for (std::size_t i = 1; i < sections.size(); ++i)
        EXPECT_LT(distance(sections[i - 1].line.places.back().point, sections[i].line[0]), 1e-6);
    const Line line = whole(plan.strokes[0]);
    for (const Place& p : line.places) {
        ASSERT_LT(p.triangle, sheet.surface.triangles.size());
        EXPECT_LT(distance(surface::nearest_in(sheet.surface, p.triangle, p.point), p.point), 0.01);
    }
    const double area = surface::area(sheet.surface);
    EXPECT_GT(covered(sheet.surface, plan, 0.51), least);
    EXPECT_LT(surface::curve::length(line) / area - covered(sheet.surface, plan, 0.51), 0.06);
    EXPECT_LT(tight(sheet.surface, plan), 0.01);
}

TEST_P(Rings, ContourIsOneGentlePath) {
    const auto sheet = GetParam().make();
    check(sheet, finished(sheet, Algorithm::geo_contour), GetParam().covered);
}

TEST_P(Rings, FisoIsOneGentlePathThatEndsWhereItBegan) {
    const auto sheet = GetParam().make();
    check(sheet, finished(sheet, Algorithm::geo_fiso), GetParam().covered - 0.03);
}

INSTANTIATE_TEST_SUITE_P(
    surfaces, Rings,
    testing::Values(
        Case{"disc", [] { return patch(40, 40, everywhere, disc(20, [](double) { return 0.0; })); }, 0.95},
        Case{"rectangle", [] { return patch(48, 32, everywhere); }, 0.93},
        Case{"hole",
             [] {
                 return patch(48, 40, [](double x, double y) { return std::abs(x - 24) > 8 || std::abs(y - 20) > 8; });
             },
             0.9},
        Case{"el", [] { return patch(48, 48, [](double x, double y) { return x < 24 || y < 24; }); }, 0.85},
        Case{"dumbbell",
             [] {
                 return patch(64, 28, [](double x, double y) { return std::abs(x - 32) > 12 || std::abs(y - 14) < 6; });
             },
             0.88},
        Case{"annulus",
             [] {
                 return patch(24, 2 * pi * 14, everywhere, [](double x, double y) -> Vec3 {
                     const double r = 8 + x / 2;
                     return {20 + r * std::cos(y / 14.001), 20 + r * std::sin(y / 14.001), 0};
                 });
             },
             0.85},
        Case{"cap", [] { return patch(40, 40, everywhere, disc(20, [](double r) { return std::sqrt(900 - r * r); })); },
             0.95},
        Case{"saddle",
             [] {
                 return patch(48, 40, everywhere, [](double x, double y) -> Vec3 {
                     return {x, y, ((x - 24) * (x - 24) - (y - 20) * (y - 20)) / 60};
                 });
             },
             0.92}),
    [](const auto& info) { return info.param.name; });

TEST(GeoFiso, BeginsAndEndsSideBySideAtTheBoundary) {
    const auto s = patch(48, 32, everywhere);
    const Plan plan = geo_fiso(s, {.algorithm = Algorithm::geo_fiso});
    ASSERT_EQ(plan.strokes.size(), 1U);
    const Line line = whole(plan.strokes[0]);
    const auto from_rim = [](const Vec3& p) { return std::min({p.x, p.y, 48 - p.x, 32 - p.y}); };
    EXPECT_LT(from_rim(line[0]), 1.2);
    EXPECT_LT(from_rim(line.places.back().point), 2.2);
}

TEST(GeoContour, LaysLinesASpacingApartAndHalfOfOneFromTheRim) {
    const auto s = patch(48, 32, everywhere);
    const Line line = whole(geo_contour(s, {.algorithm = Algorithm::geo_contour, .spacing = 2}).strokes.at(0));
    double nearest = 100;
    for (const Place& p : line.places)
        nearest = std::min({nearest, p.point.x, p.point.y, 48 - p.point.x, 32 - p.point.y});
    EXPECT_NEAR(nearest, 1, 0.06);
    EXPECT_NEAR(surface::curve::length(line) * 2 / (48 * 32), 0.95, 0.06);
}

// The last lap runs beside the rim, wherever that is.
TEST(GeoSpiral, EndsHalfASpacingFromARimThatItsFrontMeetsAtOnce) {
    for (const double radius : {20.2, 20.5, 20.8}) {
        auto s = patch(2 * radius, 2 * radius, everywhere, disc(radius, [](double) { return 0.0; }));
        const Vec3 middle{radius, radius, 0};
        std::uint32_t nearest = 0;
        for (std::uint32_t v = 0; v < s.surface.vertices.size(); ++v)
            if (distance(s.surface.vertices[v], middle) < distance(s.surface.vertices[nearest], middle)) nearest = v;
        s.sources.vertices = {nearest};
        const Plan p = plan_paths(s, {.algorithm = Algorithm::geo_spiral});
        double farthest = 0;
        for (const Stroke& stroke : p.strokes)
            for (const Place& at : whole(stroke).places)
                farthest = std::max(farthest, distance(at.point, s.surface.vertices[nearest]));
        EXPECT_NEAR(farthest, radius - 0.5, distance(s.surface.vertices[nearest], middle) + 0.1) << radius;
        EXPECT_GT(covered(s.surface, p, 0.51), 0.95) << radius;
    }
}

// A grid whose vertices lie just where rings should: rings did fall apart there, and nothing was laid.
TEST(GeoContour, RingsThroughVerticesAreWhole) {
    const auto s = patch(32, 24, everywhere);
    const Plan p = plan_paths(s, {.algorithm = Algorithm::geo_contour, .spacing = 1.6});
    ASSERT_EQ(p.strokes.size(), 1);
    double length = 0;
    for (const Section& piece : p.strokes[0].sections) length += surface::curve::length(piece.line);
    EXPECT_NEAR(1.6 * length, 32 * 24, 0.1 * 32 * 24);
}

TEST(RingTree, FindsTheNearestPointOfAllRings) {
    std::vector<Ring> rings(3);
    for (std::size_t r = 0; r < rings.size(); ++r) {
        for (int i = 0; i < 40; ++i) {
            const double a = 2 * pi * i / 40, radius = 2.0 + static_cast<double>(r);
            rings[r].line.places.push_back(
                {0, {9.0 * static_cast<double>(r) + radius * std::cos(a), radius * std::sin(a), 0}});
        }
        rings[r].line.closed = true;
        rings[r].ways = surface::curve::arc_lengths(rings[r].line);
    }
    const RingTree tree(rings);
    for (double x = -4; x < 26; x += 1.3)
        for (double y = -5; y < 5; y += 0.7) {
            const RingPosition on = tree.nearest({x, y, 0});
            double least = 1e300;
            for (const Ring& ring : rings)
                for (const Place& p : ring.line.places) least = std::min(least, distance(p.point, {x, y, 0}));
            const Ring& found = rings[on.line];
            EXPECT_LE(on.distance, least);
            EXPECT_GT(on.distance, least - 0.32); // half a step
            EXPECT_NEAR(distance(surface::curve::at(found.line, found.ways, on.way).point, {x, y, 0}), on.distance,
                        1e-9);
        }
    EXPECT_GT(RingTree({}).nearest({0, 0, 0}).distance, 1e299);
}

} // namespace
} // namespace filum::surfpath
