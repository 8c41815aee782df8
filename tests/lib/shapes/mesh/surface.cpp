// Placement, shells, holes.
#include "base/error.hpp"
#include "mesh/bodies.hpp"
#include "mesh/holes.hpp"
#include "mesh/place.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

using namespace filum;
using namespace filum::mesh;

namespace {

Mesh placed(Mesh m, const Placement& p) {
    Notes notes;
    place(m, p, false, notes);
    return m;
}

} // namespace

TEST(Place, OrderIsScaleTurnMoveCenterBed) {
    const Mesh m = shapes::box({0, 0, 3}, {1, 2, 4});
    const Box3 b = bounds(placed(
        m, {.unit = "cm", .scale = {1, 2, 1}, .rotate_deg = {0, 0, 90}, .translate = {0, 0, 7}, .center = {100, 50}}));
    EXPECT_EQ(b.lo, (Vec3{80, 45, 0})); // 10 x 40 turned to 40 x 10: exact for quarter turns
    EXPECT_EQ(b.hi, (Vec3{120, 55, 10}));
    EXPECT_EQ(bounds(placed(m, {.translate = {1, 0, -5}, .on_bed = false})).lo, (Vec3{1, 0, -2}));
}

TEST(Place, AMirroredPartStillFacesOutwards) {
    EXPECT_NEAR(volume(placed(shapes::sphere(3, 2), {.scale = {-1, 1, 1}})), volume(shapes::sphere(3, 2)), 1e-9);
    EXPECT_NEAR(volume(placed(shapes::sphere(3, 2), {.scale = {-2}})), 8 * volume(shapes::sphere(3, 2)), 1e-9);
}

TEST(Place, TurningKeepsTheVolume) {
    for (double a = -170; a < 180; a += 35)
        EXPECT_NEAR(volume(placed(shapes::torus(9, 2, 30, 12), {.rotate_deg = {a, 2 * a, 30 - a}})),
                    volume(shapes::torus(9, 2, 30, 12)), 1e-8);
}

TEST(Place, TheUnitIsGuessedFromTheSize) {
    for (const auto& [size, factor] : {std::pair{0.15, 1000.0}, std::pair{1.9, 25.4}, std::pair{60.0, 1.0}})
        EXPECT_NEAR(bounds(placed(shapes::box({0, 0, 0}, {size, size, size}), {.unit = "auto"})).hi.x, size * factor,
                    1e-9);
}

TEST(Place, WhatCannotBeObeyed) {
    EXPECT_THROW(placed(shapes::sphere(1, 1), {.scale = {1, 0, 1}}), Error);
    EXPECT_THROW(placed(shapes::sphere(1, 1), {.scale = {1, 1}}), Error);
    EXPECT_THROW(placed(shapes::sphere(1e8, 1), {}), Error);
    EXPECT_THROW(placed(shapes::sphere(1, 1), {.scale = {1e200}}), Error);
    Mesh m = shapes::sphere(1, 1);
    Notes notes;
    EXPECT_THROW(place(m, {.unit = "in"}, true, notes), Error);
}

TEST(Shells, WhatIsInsideOutIsTurned) {
    Notes notes;
    Mesh whole = shapes::inverted(
        shapes::together(shapes::box({0, 0, 0}, {9, 9, 9}), shapes::inverted(shapes::box({2, 2, 2}, {4, 4, 4}))));
    EXPECT_EQ(face_outwards(whole, false, 0.05, notes).shells, 2U);
    EXPECT_NEAR(volume(whole), 729 - 8, 1e-9);
    EXPECT_EQ(notes.size(), 1U);

    notes.clear(); // beside each other: one is wrong
    Mesh beside =
        shapes::together(shapes::box({0, 0, 0}, {9, 9, 9}), shapes::inverted(shapes::box({8, 2, 2}, {12, 4, 4})));
    face_outwards(beside, false, 0.05, notes);
    EXPECT_NEAR(volume(beside), 729 + 16, 1e-9);

    notes.clear(); // a cavity stays
    Mesh cavity =
        shapes::together(shapes::box({0, 0, 0}, {9, 9, 9}), shapes::inverted(shapes::box({2, 2, 2}, {4, 4, 4})));
    face_outwards(cavity, false, 0.05, notes);
    EXPECT_NEAR(volume(cavity), 729 - 8, 1e-9);
    EXPECT_TRUE(notes.empty());
}

TEST(Holes, ClosedIsToldFromOpen) {
    for (Mesh m : {shapes::box({0, 0, 0}, {1, 1, 1}), shapes::sphere(4, 3), shapes::torus(5, 1, 20, 9)}) {
        EXPECT_TRUE(is_closed(m));
        EXPECT_TRUE(lids(m).triangles.empty());
        Mesh flipped = m;
        std::swap(flipped.triangles[3][0], flipped.triangles[3][1]);
        EXPECT_FALSE(is_closed(flipped));
        m.triangles.pop_back();
        EXPECT_FALSE(is_closed(m));
    }
}

TEST(Holes, FlippedTrianglesAreTurnedBack) {
    for (std::uint32_t every : {2U, 3U, 7U, 100U}) {
        Mesh m = shapes::sphere(4, 4);
        const double right = volume(m);
        std::size_t flipped = 0;
        for (std::size_t t = 0; t < m.triangles.size(); ++t)
            if ((t * 2654435761U >> 7) % (every + 1) == 0) {
                std::swap(m.triangles[t][1], m.triangles[t][2]);
                ++flipped;
            }
        Notes notes;
        face_one_way(m, false, notes);
        EXPECT_TRUE(is_closed(m));
        EXPECT_NEAR(std::abs(volume(m)), right, 1e-9);
        ASSERT_EQ(notes.size(), 1U);
        EXPECT_GT(flipped, 0U);
    }
}

TEST(Holes, LidsCloseAMesh) {
    Mesh m = shapes::sphere(4, 4);
    for (std::size_t t = 0; t < m.triangles.size(); t += 97) {
        std::swap(m.triangles[t], m.triangles.back());
        m.triangles.pop_back();
    }
    EXPECT_FALSE(is_closed(m));
    const Lids l = lids(m);
    EXPECT_GT(l.holes.size(), 10U);
    m.triangles.insert(m.triangles.end(), l.triangles.begin(), l.triangles.end());
    EXPECT_TRUE(is_closed(m));
}

TEST(Holes, ASheetHasNoHole) {
    Mesh m;
    m.vertices = {{0, 0, 0}, {5, 0, 0}, {5, 0, 5}, {0, 0, 5}};
    m.triangles = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_TRUE(lids(m).holes.empty());
}
