// Paths of rows on surfaces whose answers are known: one stroke, nothing tight, everything covered.
#include "base/error.hpp"
#include "geodesic/named_sources.hpp"
#include "geodesic/query.hpp"
#include "surfpath/fexa.hpp"
#include "surfpath/fina.hpp"
#include "surfpath/geo_spiral.hpp"
#include "surfpath/plan/order.hpp"
#include "surfpath/rows/flat_turn.hpp"

#include "../../shapes/surface/grid.hpp"
#include "../../trials.hpp"
#include "plans.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <random>

namespace filum::surfpath {

using namespace rows;
namespace {

using std::numbers::pi;

// The rectangle [0, a] x [0, b] in cells of about 1 mm, put into space; cells for which `hole` holds are left out.
surface::Sheet seeded(
    double a, double b, const std::string& source, const std::function<Vec3(Vec2)>& lift,
    const std::function<bool(Vec2)>& hole = [](Vec2) { return false; }) {
    Notes notes;
    auto mesh = surface::pierced_grid(a, b, static_cast<int>(a), static_cast<int>(b), lift, hole);
    surface::Sheet out{surface::connect(std::move(mesh), notes), {}, {}};
    out.sources = geodesic::named_sources(out.surface, source, notes);
    return out;
}

Vec3 flat(Vec2 p) { return {p.x, p.y, 0}; }

// The least radius of turning along the surface outside hairpins, in steps of 0.25 mm.
double least_radius(const Surface& s, const Stroke& stroke) {
    const auto normals = surface::curve::vertex_normals(s);
    double most = 0;
    for (const Section& piece : stroke.sections) {
        if (piece.hairpin || surface::curve::length(piece.line) < 1) continue;
        const Line l = surface::curve::resampled(piece.line, 0.25);
        for (std::size_t i = 1; i + 1 < l.size(); ++i) {
            const Vec3 a = l[i] - l[i - 1], b = l[i + 1] - l[i], n = surface::curve::normal_at(s, normals, l.places[i]);
            most = std::max(most, std::abs(std::atan2(dot(cross(a, b), n), dot(a, b) - dot(a, n) * dot(b, n))) / 0.25);
        }
    }
    return 1 / most;
}

// What holds of all paths: pieces meet, and lie in their triangles.
void expect_sound(const Surface& s, const Plan& plan) {
    for (const Stroke& stroke : plan.strokes) {
        const Vec3* last = nullptr;
        for (const Section& piece : stroke.sections) {
            ASSERT_GE(piece.line.size(), 2U);
            if (last) {
                EXPECT_LT(distance(*last, piece.line[0]), 1e-6);
            }
            last = &piece.line.places.back().point;
            for (std::size_t i = 0; i < piece.line.size(); ++i) {
                const auto& at = piece.line.places[i];
                EXPECT_LT(distance(surface::nearest_in(s, at.triangle, at.point), at.point), 1e-6);
                if (i + 1 == piece.line.size()) break;
                EXPECT_LT(distance(surface::nearest_in(s, at.triangle, piece.line[i + 1]), piece.line[i + 1]), 1e-4);
            }
        }
    }
}

// Everything stays half a millimetre within the rims, or a little less round corners.
void expect_inside(const Surface& s, const Plan& plan) {
    geodesic::Sources rims;
    for (const auto& rim : s.rims)
        for (const std::uint32_t h : rim.sides)
            rims.segments.push_back({h / 3, s.vertices[s.tail(h)], s.vertices[s.head(h)]});
    const auto field = geodesic::exact(s, rims);
    double least = 1;
    for (const Stroke& stroke : plan.strokes)
        for (const Section& piece : stroke.sections)
            for (const auto& p : piece.line.places)
                least = std::min(least, geodesic::distance_at(s, field, p.triangle, p.point));
    EXPECT_GT(least, 0.39);
}

TEST(Fina, CoversARectangleInOneStrokeWithoutTightTurns) {
    const auto s = seeded(50, 40, "plane:0,1,0,17.3", flat);
    Plan plan = fina(s, {.algorithm = Algorithm::fina});
    finish(s.surface, plan, {.algorithm = Algorithm::fina});
    ASSERT_EQ(plan.strokes.size(), 1U);
    EXPECT_EQ(fact(plan, "tight-turns"), 0);
    EXPECT_EQ(fact(plan, "rows"), 40); // 17.3 in 17 rows, 22.7 in 23
    expect_sound(s.surface, plan);
    expect_inside(s.surface, plan);
    EXPECT_GT(least_radius(s.surface, plan.strokes[0]), 2.35);
    EXPECT_GT(covered(s.surface, plan), 0.97);
}

TEST(Fina, GoesRoundAHole) {
    const auto s = seeded(50, 40, "plane:0,1,0,20", flat, [](Vec2 p) { return distance(p, {20, 22}) < 6; });
    const Plan plan = fina(s, {.algorithm = Algorithm::fina});
    ASSERT_EQ(plan.strokes.size(), 1U);
    expect_sound(s.surface, plan);
    expect_inside(s.surface, plan);
    EXPECT_GT(covered(s.surface, plan), 0.92);
}

TEST(Fina, RowsAreStraightBehindAHole) {
    const auto s = seeded(50, 40, "plane:0,1,0,0", flat, [](Vec2 p) { return distance(p, {25, 20}) < 4; });
    const Plan plan = fina(s, {.algorithm = Algorithm::fina});
    for (const Stroke& stroke : plan.strokes)
        for (const Section& piece : stroke.sections)
            for (const auto& p : piece.line.places)
                if (std::abs(p.point.x - 25) < 8 && p.point.y > 26 && p.point.y < 39) {
                    EXPECT_NEAR(p.point.y - std::floor(p.point.y), 0.5, 1e-3);
                }
}

TEST(Fina, CoversAnLInOneStroke) {
    const auto s = seeded(40, 40, "plane:0,1,0,10", flat, [](Vec2 p) { return p.x > 20 && p.y > 20; });
    const Plan plan = fina(s, {.algorithm = Algorithm::fina});
    ASSERT_EQ(plan.strokes.size(), 1U);
    expect_sound(s.surface, plan);
    expect_inside(s.surface, plan);
    EXPECT_GT(covered(s.surface, plan), 0.96);
}

TEST(Fina, CoversASaddle) {
    const auto s = seeded(40, 40, "plane:1,0,0,0", [](Vec2 p) {
        return Vec3{p.x - 20, p.y - 20, ((p.x - 20) * (p.x - 20) - (p.y - 20) * (p.y - 20)) / 80};
    });
    const Plan plan = fina(s, {.algorithm = Algorithm::fina});
    ASSERT_EQ(plan.strokes.size(), 1U);
    expect_sound(s.surface, plan);
    EXPECT_GT(least_radius(s.surface, plan.strokes[0]), 1.75); // less is declared as hairpins
    EXPECT_GT(covered(s.surface, plan), 0.95);
}

TEST(Fina, ClosedRowsBecomeAHelix) {
    // A tube: the rectangle rolled up, welded where its sides meet.
    mesh::Mesh mesh;
    const int n = 60, m = 20;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i < n; ++i)
            mesh.vertices.push_back({10 * std::cos(2 * pi * i / n), 10 * std::sin(2 * pi * i / n), 1.0 * j});
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const auto at = [&](int k, int l) { return static_cast<std::uint32_t>(l * n + k % n); };
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    Notes notes;
    surface::Sheet s{surface::connect(std::move(mesh), notes), {}, {}};
    s.sources = geodesic::named_sources(s.surface, "plane:0,0,1,8", notes);
    const Plan plan = fina(s, {.algorithm = Algorithm::fina});
    ASSERT_EQ(plan.strokes.size(), 1U);
    ASSERT_EQ(plan.strokes[0].sections.size(), 1U);
    expect_sound(s.surface, plan);
    const Line& l = plan.strokes[0].sections[0].line;
    EXPECT_NEAR(surface::curve::length(l), 20 * 60 * 2 * 10 * std::sin(pi / 60),
                40); // area by spacing; the ends are not counted
    double turned = 0;
    for (std::size_t i = 1; i < l.size(); ++i)
        turned += std::atan2(l[i - 1].x * l[i].y - l[i - 1].y * l[i].x, l[i - 1].x * l[i].x + l[i - 1].y * l[i].y);
    EXPECT_NEAR(std::abs(turned) / (2 * pi), 20, 0.8); // always the same way round
}

TEST(Fina, IsTheSameEveryTime) {
    FILUM_NOT_SANITIZED();
    const auto s = seeded(30, 30, "plane:1,2,0,40", flat);
    const Plan a = fina(s, {.algorithm = Algorithm::fina}), b = fina(s, {.algorithm = Algorithm::fina});
    ASSERT_EQ(a.strokes.size(), b.strokes.size());
    for (std::size_t i = 0; i < a.strokes.size(); ++i) {
        ASSERT_EQ(a.strokes[i].sections.size(), b.strokes[i].sections.size());
        for (std::size_t k = 0; k < a.strokes[i].sections.size(); ++k)
            EXPECT_EQ(a.strokes[i].sections[k].line.places.back().point,
                      b.strokes[i].sections[k].line.places.back().point);
    }
}

TEST(Fina, NeedsASeedCurve) {
    EXPECT_THROW(fina(seeded(10, 10, "vertex:0", flat), {.algorithm = Algorithm::fina}), Error);
}

TEST(Fina, NotesASurfaceNarrowerThanTheSpacing) {
    const Plan plan = fina(seeded(20, 4, "plane:0,1,0,2", flat), {.algorithm = Algorithm::fina, .spacing = 50});
    EXPECT_TRUE(plan.strokes.empty());
    ASSERT_EQ(plan.notes.size(), 1U);
    EXPECT_NEAR(plan.notes[0].amount, 80, 1e-9);
}

TEST(Fina, AnyRadiusWillDo) {
    const auto s = seeded(20, 10, "plane:0,1,0,5", flat);
    for (const double radius : {0.0, 1e-9, 1e6}) {
        const Plan plan = fina(s, {.algorithm = Algorithm::fina, .least_radius = radius});
        ASSERT_EQ(plan.strokes.size(), 1U) << radius;
        expect_sound(s.surface, plan);
        EXPECT_GT(covered(s.surface, plan), 0.9) << radius;
    }
}

TEST(Fexa, RowsLieAsFarApartOnASlope) {
    // A roof of 60 degrees: planes across the slope must be half a spacing apart.
    const auto s = seeded(40, 40, "plane:1,0,0,0", [](Vec2 p) { return Vec3{p.x / 2, p.y, p.x * std::sqrt(0.75)}; });
    const Plan plan = fexa(s, {.algorithm = Algorithm::fexa});
    ASSERT_EQ(plan.strokes.size(), 1U);
    EXPECT_EQ(fact(plan, "rows"), 40);
    expect_sound(s.surface, plan);
    EXPECT_GT(covered(s.surface, plan), 0.96);
    for (const Section& piece : plan.strokes[0].sections)
        for (const auto& p : piece.line.places)
            if (std::abs(p.point.y - 20) < 10) {
                const double row = 2 * p.point.x; // along the slope
                EXPECT_NEAR(row - std::floor(row), 0.5, 2e-2);
            }
}

TEST(Fexa, NotesWhereTheSurfaceLeansTowardsThePlane) {
    // Steeper and steeper across, and the same everywhere along the rows: nothing is too wide.  Then a twist: the slope
    // across differs along the rows.
    const auto even = seeded(20, 20, "plane:1,0,0,0", [](Vec2 p) { return Vec3{p.x, p.y, p.x * p.x / 20}; });
    EXPECT_TRUE(fexa(even, {.algorithm = Algorithm::fexa}).notes.empty());
    const auto twisted = seeded(20, 20, "plane:1,0,0,10", [](Vec2 p) { return Vec3{p.x, p.y, p.x * p.y * p.y / 200}; });
    const Plan plan = fexa(twisted, {.algorithm = Algorithm::fexa});
    double area = 0;
    for (const Note& note : plan.notes)
        if (note.code == NoteCode::rows_apart) area = note.amount;
    EXPECT_GT(area, 20);
    EXPECT_LT(area, 400);
}

TEST(Fexa, NeedsASeedInAPlane) {
    auto s = seeded(10, 10, "plane:1,0,0,5", flat);
    s.sources.segments.push_back({0, {0, 0, 0}, {0.5, 0, 0}});
    s.sources.segments.push_back({0, {0, 0, 3}, {0.5, 0, 3}});
    EXPECT_THROW(fexa(s, {.algorithm = Algorithm::fexa}), Error);
}

TEST(GeoSpiral, WindsOverADiscInOneStroke) {
    const auto s = seeded(40, 40, "point:20,20,0", flat, [](Vec2 p) { return distance(p, {20, 20}) > 18; });
    const Plan plan = geo_spiral(s, {.algorithm = Algorithm::geo_spiral});
    ASSERT_EQ(plan.strokes.size(), 1U);
    expect_sound(s.surface, plan);
    EXPECT_GT(covered(s.surface, plan), 0.92);
}

TEST(GeoSpiral, GoesOnWhereTheFrontMeetsTheRim) {
    const auto s = seeded(60, 30, "point:20,15,0", flat);
    const Plan plan = geo_spiral(s, {.algorithm = Algorithm::geo_spiral});
    ASSERT_EQ(plan.strokes.size(), 1U);
    expect_sound(s.surface, plan);
    EXPECT_GT(covered(s.surface, plan), 0.92);
}

TEST(GeoSpiral, NeedsAPoint) {
    EXPECT_THROW(geo_spiral(seeded(10, 10, "plane:1,0,0,5", flat), {.algorithm = Algorithm::geo_spiral}), Error);
}

TEST(Order, RowsThatMayOnlyJumpFourToSeven) {
    for (const std::uint32_t n : {33U, 60U}) {
        std::vector<Link> links;
        for (std::uint32_t a = 0; a < n; ++a)
            for (const std::uint32_t jump : {4U, 5U, 6U, 7U})
                if (a + jump < n)
                    for (std::uint32_t side = 0; side < 2; ++side)
                        links.push_back({2 * a + side, 2 * (a + jump) + side, 1.0 * jump});
        const auto chains = order(n, links, {1000, 0}, 500);
        ASSERT_EQ(chains.size(), 1U) << n;
        ASSERT_EQ(chains[0].size(), n) << n;
        for (std::size_t i = 1; i < n; ++i) {
            const Visit &a = chains[0][i - 1], &b = chains[0][i];
            EXPECT_NE(a.reversed, b.reversed); // they meet at the same side
            const auto jump = std::max(a.row, b.row) - std::min(a.row, b.row);
            EXPECT_TRUE(jump >= 4 && jump <= 7);
        }
    }
}

TEST(Order, NeverClosesARing) {
    const std::vector<Link> links{{0, 2, 1}, {1, 3, 1}};
    const auto chains = order(2, links, {10, 0}, 10);
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_EQ(chains[0].size(), 2U);
}

TEST(Order, WhatHasNoLinkIsAChainOfItsOwn) {
    EXPECT_EQ(order(3, {}, {10, 0}, 10).size(), 3U);
    EXPECT_TRUE(order(0, {}, {10, 0}, 10).empty());
}

// Two upright rows `apart` mm apart that end on the x axis.
FlatTurn upright(double apart, double radius) {
    std::vector<Vec2> first, second;
    for (int i = 0; i <= 60; ++i) {
        first.push_back({0, -0.25 * i});
        second.push_back({apart, -0.25 * i});
    }
    const std::vector<Vec2> bound{{0, 0}, {apart, 0}};
    return turn({first, second, bound}, radius);
}

TEST(Turn, IsAHalfCircleAtTwoRadii) {
    const FlatTurn t = upright(5, 2.5);
    EXPECT_NEAR(t.length, pi * 2.5, 0.01);
    EXPECT_NEAR(t.from_first, 2.5, 1e-6);
    EXPECT_NEAR(t.from_second, 2.5, 1e-6);
}

TEST(Turn, RunsAlongTheBoundWhereThereIsRoom) {
    const FlatTurn t = upright(9, 2.5);
    EXPECT_NEAR(t.length, pi * 2.5 + 4, 0.01);
    double top = -1;
    for (const Vec2 p : t.points) top = std::max(top, p.y);
    EXPECT_NEAR(top, 0, 1e-9);
}

TEST(Turn, IsABulbBetweenNearRows) {
    const FlatTurn t = upright(1, 2.5);
    EXPECT_TRUE(t.bulb);
    for (std::size_t i = 1; i + 1 < t.points.size(); ++i) {
        const Vec2 a = t.points[i] - t.points[i - 1], b = t.points[i + 1] - t.points[i];
        if (norm(a) > 1e-3 && norm(b) > 1e-3) {
            EXPECT_LT(std::abs(std::atan2(cross(a, b), dot(a, b))) / norm(a), 1.1 / 2.5);
        }
    }
    EXPECT_EQ(t.points.front().x, 0);
    EXPECT_NEAR(t.points.back().x, 1, 1e-9);
}

} // namespace
} // namespace filum::surfpath
