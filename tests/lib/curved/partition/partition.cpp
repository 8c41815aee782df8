#include "partition/partition.hpp"
#include "base/error.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

namespace filum::partition {
namespace {

double rims(const Sheet& sheet) {
    double sum = 0;
    for (const auto& rim : sheet.surface.rims) sum += surface::rim_length(sheet.surface, rim);
    return sum;
}

TEST(Partition, TwoDirectionsGiveTwoPatchesWithAStraightBorderBetween) {
    for (const double turn : {0.0, 0.4}) { // the border oblique to the triangles
        Sheet sheet = grid(40, 20, 40, 20, flat);
        const Vec2 n{std::cos(turn), std::sin(turn)};
        const auto beyond = [&](Vec3 p) { return (p.x - 20) * n.x + (p.y - 10) * n.y; };
        add_stress(sheet, "X", [&](Vec3 p) { return beyond(p) < 0 ? Vec3{0, 5, 0} : Vec3{-5, 0, 0}; });
        Notes notes;
        const auto patches = divide(sheet, {}, 1, notes);
        ASSERT_EQ(patches.size(), 2U);
        EXPECT_TRUE(notes.empty());
        EXPECT_NEAR(total(patches), 800, 1e-9);
        for (const auto& p : patches) {
            EXPECT_EQ(p.surface.rims.size(), 1U);
            EXPECT_NEAR(surface::area(p.surface), 400, 11); // half a triangle
            EXPECT_GT(figures(p, {}).coherence, 0.985);
        }
        EXPECT_NEAR(rims(patches[0]) + rims(patches[1]), 120 + 2 * 20 / n.x, 1.5); // jagged: 1.3 times and more
    }
}

TEST(Partition, ASignOfDirectionsMeansNothing) {
    Sheet sheet = grid(30, 20, 30, 20, flat);
    int k = 0;
    add_stress(sheet, "X", [&](Vec3) { return ++k % 2 == 0 ? Vec3{0, 5, 0} : Vec3{0, -5, 0}; });
    Notes notes;
    const auto patches = divide(sheet, {}, 1, notes);
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_NEAR(figures(patches[0], {}).coherence, 1, 1e-9);
}

TEST(Partition, OnePatchIsTheSurfaceAsItCame) {
    Sheet sheet = grid(30, 20, 10, 10, flat);
    sheet.fields.push_back({"distance", std::vector<double>(sheet.surface.vertices.size(), 1.0), 1});
    sheet.isolines.push_back({1, false, {{0, 0, 0}, {1, 0, 0}}, {0}});
    sheet.sources.vertices = {3};
    Notes notes;
    const auto patches = divide(sheet, {}, 1, notes);
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_EQ(patches[0].isolines.size(), 1U);
    EXPECT_EQ(patches[0].sources.vertices.size(), 1U);
    EXPECT_TRUE(notes.empty());
}

// A sheet folded by 90 degrees: sharply, or round with radius 10.
Vec3 folded(Vec2 p, double radius) {
    const double round = radius * std::numbers::pi / 2;
    if (p.x <= 20) return {p.x, p.y, 0};
    if (p.x >= 20 + round) return {20 + radius, p.y, radius + (p.x - 20 - round)};
    const double angle = (p.x - 20) / radius;
    return {20 + radius * std::sin(angle), p.y, radius * (1 - std::cos(angle))};
}

TEST(Partition, ASharpFoldIsABorderARoundOneOnlyBeyondTheBend) {
    const double length = 40 + 5 * std::numbers::pi;
    Notes notes;
    Options by_shape;
    by_shape.pull.by = PullOptions::Basis::shape;
    EXPECT_EQ(divide(grid(40, 20, 40, 20, [](Vec2 p) { return folded(p, 0); }), by_shape, 1, notes).size(), 2U);
    const Sheet round = grid(length, 20, 56, 20, [](Vec2 p) { return folded(p, 10); });
    EXPECT_EQ(divide(round, by_shape, 1, notes).size(), 1U);
    by_shape.limits.bend_deg = 30;
    const auto patches = divide(round, by_shape, 1, notes);
    EXPECT_GE(patches.size(), 2U);
    EXPECT_LE(patches.size(), 3U);
    for (const auto& p : patches) EXPECT_LT(figures(p, {}).bend, 36 * kDegree);
}

TEST(Partition, DirectionsAroundATubeAreCoherentOnIt) {
    // A third of a tube of radius 20: hoop directions turn in space, but not on the surface.
    const auto tube = [](Vec2 p) { return Vec3{20 * std::sin(p.x / 20), p.y, 20 * std::cos(p.x / 20)}; };
    Sheet sheet = grid(34, 20, 34, 20, tube);
    add_stress(sheet, "X", [](Vec3 p) { return Vec3{p.z, 0, -p.x}; });
    Notes notes;
    const auto patches = divide(sheet, {}, 1, notes);
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_GT(figures(patches[0], {}).coherence, 0.9999);
}

TEST(Partition, AClosedBallFallsIntoDiscs) {
    const Sheet sheet = ball(20, 5);
    Notes notes;
    const auto patches = divide(sheet, {}, 1, notes);
    EXPECT_GE(patches.size(), 4U);
    EXPECT_LE(patches.size(), 14U);
    EXPECT_NEAR(total(patches), surface::area(sheet.surface), 1e-6);
    for (const auto& p : patches) EXPECT_LT(figures(p, {}).bend, 60 * kDegree);
}

TEST(Partition, TheLoadCaseThatPullsMostDecides) {
    Sheet sheet = grid(40, 20, 40, 20, flat);
    add_stress(sheet, "X", [](Vec3 p) { return Vec3{p.x < 20 ? 9.0 : 1.0, 0, 0}; });
    add_stress(sheet, "Y", [](Vec3 p) { return Vec3{0, p.x < 20 ? 1.0 : 9.0, 0}; });
    Notes notes;
    EXPECT_EQ(divide(sheet, {}, 1, notes).size(), 2U);
    Options only;
    only.pull.cases = {"Y"};
    EXPECT_EQ(divide(sheet, only, 1, notes).size(), 1U);
}

TEST(Partition, StressOutOfTheSurfaceSaysNothing) {
    Sheet sheet = grid(40, 20, 40, 20, flat);
    add_stress(sheet, "X", [](Vec3 p) { return p.x < 20 ? Vec3{5, 0, 0} : Vec3{0.001, 0.3, 40}; });
    Notes notes;
    EXPECT_EQ(divide(sheet, {}, 1, notes).size(), 1U);
}

TEST(Partition, TheMaskLeavesOutWhatBearsLittleAndSaysSo) {
    Sheet sheet = grid(40, 20, 40, 20, flat);
    add_stress(sheet, "X", [](Vec3 p) { return Vec3{10 * (1 - p.x / 40), 0, 0}; });
    Options options;
    options.mask = 0.25;
    Notes notes;
    const auto patches = divide(sheet, options, 1, notes);
    ASSERT_EQ(patches.size(), 1U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::unloaded_dropped);
    EXPECT_NEAR(notes[0].amount, 200, 10);
    EXPECT_NEAR(total(patches) + notes[0].amount, 800, 1e-6);
    for (const Vec3& v : patches[0].surface.vertices) EXPECT_LT(v.x, 31);
    ASSERT_EQ(patches[0].fields.size(), 2U);
    for (std::size_t v = 0; v < patches[0].surface.vertices.size(); ++v) // also of new vertices
        EXPECT_NEAR(patches[0].fields[0].values[v], 10 * (1 - patches[0].surface.vertices[v].x / 40), 1e-9);
}

TEST(Partition, ACountOfPatchesIsKept) {
    Sheet sheet = grid(40, 20, 40, 20, flat);
    add_stress(sheet, "X", [](Vec3 p) { return Vec3{std::cos(p.x / 13), std::sin(p.x / 13), 0}; });
    Options options;
    Notes notes;
    for (const std::int64_t n : {1, 3, 5}) {
        options.limits.patches = n;
        EXPECT_EQ(divide(sheet, options, 1, notes).size(), static_cast<std::size_t>(n));
    }
}

TEST(Partition, FacesOfTheDesignAreBordersIfAsked) {
    Sheet sheet = grid(40, 20, 40, 20, flat);
    for (std::uint32_t t = 0; t < sheet.surface.triangles.size(); ++t)
        sheet.faces.push_back(middle(sheet.surface, t).x < 15 ? 7 : 9);
    Options options;
    Notes notes;
    EXPECT_EQ(divide(sheet, options, 1, notes).size(), 1U);
    options.seams.faces = true;
    const auto patches = divide(sheet, options, 1, notes);
    ASSERT_EQ(patches.size(), 2U);
    EXPECT_NEAR(surface::area(patches[0].surface), 500, 1e-9);
    for (const auto f : patches[0].faces) EXPECT_EQ(f, 9U);
    sheet.faces.clear();
    EXPECT_THROW(divide(sheet, options, 1, notes), Error);
}

TEST(Partition, WhatIsTooSmallIsJoinedOrNoted) {
    // A lid of 2 x 20 at 90 degrees to a plate of 40 x 20: too small, and an edge keeps it away.
    const Sheet sheet = grid(42, 20, 42, 20, [](Vec2 p) { return p.x < 40 ? flat(p) : Vec3{40, p.y, p.x - 40}; });
    Options options;
    options.limits.least_area = 50;
    Notes notes;
    const auto patches = divide(sheet, options, 1, notes);
    ASSERT_EQ(patches.size(), 1U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::face_too_small);
    EXPECT_NEAR(notes[0].amount, 40, 1e-9);
    EXPECT_NEAR(notes[0].x, 40, 1e-9);
    options.limits.least_area = 900;
    EXPECT_THROW(divide(sheet, options, 1, notes), Error);
}

TEST(Partition, ABumpOfAScanIsNoFace) {
    const Sheet sheet = grid(40, 20, 40, 20, [](Vec2 p) { return Vec3{p.x, p.y, p == Vec2{20, 10} ? 0.9 : 0.0}; });
    Notes notes;
    EXPECT_EQ(divide(sheet, {}, 1, notes).size(), 1U);
    EXPECT_TRUE(notes.empty());
}

TEST(Partition, ASpikeOfAScanIsNoHole) {
    const Sheet sheet = grid(40, 20, 40, 20, [](Vec2 p) { return Vec3{p.x, p.y, p == Vec2{20, 10} ? 8.0 : 0.0}; });
    Options options;
    options.detail = 8;
    options.limits.least_area = 30;
    Notes notes;
    const auto patches = divide(sheet, options, 1, notes);
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_EQ(patches[0].surface.rims.size(), 1U);
}

TEST(Partition, ThatThereAreNotAsManyAsAskedForIsSaid) {
    mesh::Mesh m{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {20, 0, 0}, {29, 0, 0}, {20, 9, 0}}, {{0, 1, 2}, {3, 4, 5}}};
    Notes notes;
    Sheet sheet;
    sheet.surface = surface::connect(std::move(m), notes);
    Options options;
    options.limits.patches = 1;
    EXPECT_EQ(divide(sheet, options, 1, notes).size(), 2U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::patches_more);
}

TEST(Partition, ATubeIsNotClosedOfWhatIsTooSmall) {
    const Sheet sheet = grid(2 * std::numbers::pi, 6, 48, 12, [](Vec2 p) {
        return Vec3{2 * std::cos(p.x), 2 * std::sin(p.x), p.y};
    });
    Options options;
    options.limits.least_area = 15;
    Notes notes;
    const auto patches = divide(sheet, options, 1, notes);
    EXPECT_GE(patches.size(), 3U);
    for (const auto& p : patches) EXPECT_LT(figures(p, {}).bend, 75 * kDegree);
    options.limits.least_area = 40; // of 75
    EXPECT_THROW(divide(sheet, options, 1, notes), Error);
}

TEST(Partition, MissingStressesAreErrorsOnlyIfAskedFor) {
    const Sheet sheet = grid(10, 10, 5, 5, flat);
    Notes notes;
    Options options;
    options.pull.by = PullOptions::Basis::stress;
    EXPECT_THROW(divide(sheet, options, 1, notes), Error);
    options.pull = {.by = PullOptions::Basis::either, .cases = {"Z"}, .field = ""};
    EXPECT_THROW(divide(sheet, options, 1, notes), Error);
    options.pull = {.by = PullOptions::Basis::either, .cases = {}, .field = "wind"};
    EXPECT_THROW(divide(sheet, options, 1, notes), Error);
    options = {};
    options.mask = 0.1;
    EXPECT_THROW(divide(sheet, options, 1, notes), Error);
}

} // namespace
} // namespace filum::partition
