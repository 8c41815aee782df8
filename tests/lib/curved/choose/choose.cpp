// Choices whose answers are known: rectangles and rings pulled along known directions.
#include "choose/choose.hpp"

#include "../../trials.hpp"
#include "base/error.hpp"
#include "choose/rim_sides.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace filum::choose {
namespace {

using std::numbers::pi;

// The rectangle [0, a] x [0, b] in cells of about 1 mm, put into space, pulled with 1 MPa along `pull`.
Sheet sheet(double a, double b, const std::function<Vec3(Vec3)>& lift, const std::function<Vec3(Vec3)>& pull) {
    const int n = static_cast<int>(a), m = static_cast<int>(b);
    mesh::Mesh mesh;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i) mesh.vertices.push_back(lift({a * i / n, b * j / m, 0}));
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const auto p = static_cast<std::uint32_t>(j * (n + 1) + i), up = static_cast<std::uint32_t>(n + 1);
            mesh.triangles.push_back({p, p + 1, p + up + 1});
            mesh.triangles.push_back({p, p + up + 1, p + up});
        }
    Notes notes;
    Sheet out{surface::connect(std::move(mesh), notes), {}, {}};
    if (!pull) return out;
    surface::Field d1{"stress.X.d1", {}, 3}, s1{"stress.X.s1", {}, 1};
    for (const Vec3& p : out.surface.vertices) {
        const Vec3 d = pull(p);
        d1.values.insert(d1.values.end(), {d.x, d.y, d.z});
        s1.values.push_back(1);
    }
    out.fields = {s1, d1};
    return out;
}

Vec3 flat(Vec3 p) { return p; }

std::function<Vec3(Vec3)> towards(double deg) {
    return [deg](Vec3) { return Vec3{std::cos(deg * pi / 180), std::sin(deg * pi / 180), 0}; };
}

// A quarter of the ring between 20 and 20 + b mm about the origin, pulled round it.
Sheet ring(double b) {
    return sheet(
        40, b,
        [](Vec3 p) {
            return (20 + p.y) * Vec3{std::cos(p.x / 40 * pi / 2), std::sin(p.x / 40 * pi / 2), 0};
        },
        [](Vec3 p) {
            return 1 / norm(p) * Vec3{-p.y, p.x, 0};
        });
}

Options wide() {
    Options out;
    out.plan.spacing = 2;
    return out;
}

TEST(Score, IsTheMeanOfTermsByWeights) {
    const Criteria c{100, 0.9, 0.5, 0.4, 9, 2, 400, 0.1};
    EXPECT_DOUBLE_EQ(score(c, {1, 0, 0, 0, 0}, 50), 0.9);
    EXPECT_DOUBLE_EQ(score(c, {0, 1, 0, 0, 0}, 50), 0.5);
    EXPECT_DOUBLE_EQ(score(c, {0, 0, 1, 0, 0}, 50), 0.9);
    EXPECT_DOUBLE_EQ(score(c, {0, 0, 0, 1, 0}, 50), 0.75);
    EXPECT_DOUBLE_EQ(score(c, {0, 0, 0, 1, 0}, 500), 0); // never below
    EXPECT_DOUBLE_EQ(score(c, {0, 0, 0, 0, 1}, 50), 0.9);
    EXPECT_DOUBLE_EQ(score(c, {1, 3, 0, 0, 0}, 50), (0.9 + 3 * 0.5) / 4);
    Criteria bare = c;
    bare.load = std::nan("");
    EXPECT_DOUBLE_EQ(score(bare, {1, 3, 0, 0, 0}, 50), 0.9);
}

TEST(Score, WeightsAreRead) {
    const Weights w = weights("load=3,cuts=0");
    EXPECT_EQ(w.load, 3);
    EXPECT_EQ(w.cuts, 0);
    EXPECT_EQ(w.coverage, Weights{}.coverage);
    for (const char* bad :
         {"beauty=1", "load", "load=", "load=-1", "load=inf", "load=nan", "coverage=0,load=0,angle=0,cuts=0,overlap=0"})
        EXPECT_THROW((void)weights(bad), Error) << bad;
}

TEST(RimSides, OfARectangleAreItsSidesAndOfADiscItsRim) {
    const auto s = sheet(30, 20, flat, {});
    const auto sides = longest_sides(s.surface, 3);
    ASSERT_EQ(sides.size(), 3);
    EXPECT_NEAR(sides[0].length, 30, 1e-9);
    EXPECT_NEAR(sides[1].length, 30, 1e-9);
    EXPECT_NEAR(sides[2].length, 20, 1e-9);
    EXPECT_NEAR(distance(sides[0].from, sides[0].to), 30, 1e-9);
    mesh::Mesh disc{{{0, 0, 0}}, {}};
    for (std::uint32_t i = 0; i < 90; ++i) {
        disc.vertices.push_back({9 * std::cos(i * pi / 45), 9 * std::sin(i * pi / 45), 0});
        disc.triangles.push_back({0, 1 + i, 1 + (i + 1) % 90});
    }
    Notes notes;
    const auto whole = longest_sides(surface::connect(std::move(disc), notes), 6);
    ASSERT_EQ(whole.size(), 1);
    EXPECT_EQ(whole[0].from, whole[0].to);
    EXPECT_NEAR(whole[0].length, 2 * pi * 9, 0.1);
}

TEST(Seed, ALineAlongThePullStaysOnItsCircle) {
    const Sheet s = ring(20);
    const auto pull = pulls(s);
    const Seed along{Seed::Kind::along, {}, {30 * std::cos(0.5), 30 * std::sin(0.5), 0}, {}};
    double length = 0;
    for (const auto& part : sources(s, pull, along).segments) {
        EXPECT_NEAR(norm(part.a), 30, 0.05);
        length += distance(part.a, part.b);
    }
    EXPECT_NEAR(length, 15 * pi, 0.1);
    Seed across = along;
    across.kind = Seed::Kind::across;
    length = 0;
    for (const auto& part : sources(s, pull, across).segments) {
        EXPECT_NEAR(std::atan2(part.a.y, part.a.x), 0.5, 0.01);
        length += distance(part.a, part.b);
    }
    EXPECT_NEAR(length, 20, 0.1);
}

TEST(Estimate, IsTheCosineBetweenLinesAndPull) {
    for (const double deg : {0.0, 25.0, 70.0}) {
        const Sheet s = sheet(30, 20, flat, towards(deg));
        const auto pull = pulls(s);
        const Seed middle{Seed::Kind::plane, {{0, 1, 0}, 10.3}, {}, {}};
        const double along = std::cos(deg * pi / 180), across = std::sin(deg * pi / 180);
        EXPECT_NEAR(estimate(s, pull, {surfpath::Algorithm::fexa, middle}), along, 1e-9);
        EXPECT_NEAR(estimate(s, pull, {surfpath::Algorithm::fina, middle}), along, 0.02);
        EXPECT_NEAR(estimate(s, pull, {surfpath::Algorithm::ortheo, middle}), across, 0.06);
    }
    EXPECT_TRUE(std::isnan(estimate(sheet(9, 9, flat, {}), {}, {surfpath::Algorithm::geo_fiso, {}})));
}

TEST(Choose, RowsFollowThePull) {
    for (const double deg : kSanitized ? std::vector{50.0} : std::vector{0.0, 50.0}) {
        Sheet s = sheet(24, 20, flat, towards(deg));
        Options o = wide();
        o.plan.least_radius = 1;
        Notes notes;
        const Choice c = choose(s, o, 1, notes);
        ASSERT_NE(c.best, kNothing);
        EXPECT_GT(c.trials[c.best].found->load, 0.8) << deg;
        EXPECT_GT(c.trials[c.best].found->coverage, 0.8) << deg;
        EXPECT_EQ(s.algorithm, surfpath::name(c.trials[c.best].candidate.algorithm));
        const bool by_field = s.algorithm == surfpath::name(surfpath::Algorithm::field);
        EXPECT_EQ(s.sources.empty(), by_field);
        EXPECT_EQ(s.fields.back().name, by_field ? surfpath::kDirection : "distance");
        for (const Trial& t : c.trials) EXPECT_LE(t.score, c.trials[c.best].score);
    }
}

TEST(Choose, ARingThatIsPulledRoundIsFilledRound) {
    Sheet s = ring(12);
    Options o = wide();
    o.finals = 1;
    Notes notes;
    const Choice c = choose(s, o, 1, notes);
    ASSERT_NE(c.best, kNothing);
    EXPECT_GT(c.trials[c.best].found->load, 0.8);
}

TEST(Choose, DoesNotDependOnThreads) {
    Sheet one = sheet(20, 12, flat, towards(20)), two = one;
    Options o = wide();
    o.finals = 2;
    Notes notes;
    const Choice a = choose(one, o, 1, notes), b = choose(two, o, 3, notes);
    EXPECT_EQ(report("A", a), report("A", b));
    EXPECT_EQ(one.algorithm, two.algorithm);
    ASSERT_EQ(one.sources.segments.size(), two.sources.segments.size());
    EXPECT_EQ(one.fields.back().values, two.fields.back().values);
}

TEST(Choose, WhatThePatchCameWithIsLaidToo) {
    Sheet s = sheet(20, 12, flat, towards(0));
    s.algorithm = "geo-contour";
    s.sources = sources(s, {}, {});
    Options o = wide();
    o.finals = 1;
    Notes notes;
    const Choice c = choose(s, o, 1, notes);
    ASSERT_EQ(c.trials[0].candidate.algorithm, surfpath::Algorithm::geo_contour);
    ASSERT_TRUE(c.trials[0].found);
    EXPECT_GE(c.trials[c.best].score, c.trials[0].score);
}

TEST(Choose, ByHandNothingElseIsTried) {
    Sheet s = sheet(20, 12, flat, towards(0));
    Options o = wide();
    o.plan.algorithm = surfpath::Algorithm::geo_contour;
    o.by_hand = true;
    Notes notes;
    const Choice c = choose(s, o, 1, notes);
    ASSERT_EQ(c.trials.size(), 1);
    EXPECT_EQ(s.algorithm, "geo-contour");
    o.plan.algorithm = surfpath::Algorithm::geo_spiral; // rims are no point
    const Choice none = choose(s, o, 1, notes);
    EXPECT_EQ(none.best, kNothing);
    EXPECT_NE(none.trials[0].failed, "");
}

TEST(Candidates, PlanesStandUprightOnAxesThatAreNear) {
    const double lean = 0.01;
    const Sheet s = sheet(
        30, 20,
        [&](Vec3 p) {
            return Vec3{p.x - lean * p.y, p.y + lean * p.x, 0};
        },
        towards(0));
    bool found = false;
    for (const Candidate& c : candidates(s, pulls(s)))
        if (c.seed.kind == Seed::Kind::plane && c.seed.plane.normal == Vec3{0, 1, 0}) found = true;
    EXPECT_TRUE(found);
}

TEST(Choose, WhatNothingFillsIsNotedWithItsArea) {
    Sheet s = sheet(2, 2, flat, {});
    Options o;
    o.plan.spacing = 50;
    Notes notes;
    const Choice c = choose(s, o, 1, notes);
    EXPECT_EQ(c.best, kNothing);
    EXPECT_EQ(s.algorithm, "");
    ASSERT_EQ(notes.size(), 1);
    EXPECT_EQ(notes[0].code, NoteCode::no_path_found);
    EXPECT_NEAR(notes[0].amount, 4, 1e-9);
    for (const Trial& t : c.trials) EXPECT_FALSE(t.found);
}

} // namespace
} // namespace filum::choose
