// Toolpaths one behind the other.
#include "toolpath/assembly.hpp"

#include "mesh/place.hpp"

#include <gtest/gtest.h>

namespace filum::toolpath {
namespace {

using geom::Vec3;

Span bead(std::uint32_t stroke, Vec3 a, Vec3 b) { return {Role::bead, stroke, 0, 0, {a, b}, {1}, {0.2}, {}}; }

TEST(Assembly, NumbersStrokesOnAndTravelsAlongBothAxes) {
    Assembly job({.lift = 4});
    job.begin();
    EXPECT_EQ(job.add(bead(0, {0, 0, 1}, {10, 0, 1})).size(), 1U);
    EXPECT_EQ(job.add(bead(2, {10, 0, 1}, {20, 0, 1}))[0].stroke, 2U);
    job.begin();
    Span patch = bead(0, {0, 30, 5}, {0, 40, 5});
    patch.normals = {{1, 0, 0}, {1, 0, 0}};
    const auto out = job.add(patch);
    ASSERT_EQ(out.size(), 2U);
    EXPECT_EQ(out[0].role, Role::travel);
    EXPECT_EQ(out[0].stroke, 3U);
    EXPECT_EQ(out[1].stroke, 3U);
    const Vec3 up{0, 0, 1}, x{1, 0, 0};
    const std::vector<Vec3> way{{20, 0, 1}, {20, 0, 5}, {20, 0, 5}, {20, 0, 5},
                                {4, 30, 5}, {4, 30, 5}, {4, 30, 5}, {0, 30, 5}};
    EXPECT_EQ(out[0].points, way);
    const std::vector<Vec3> axes{up, up, up, up, up, up, x, x};
    EXPECT_EQ(out[0].normals, axes);
    EXPECT_EQ(job.add(bead(1, {0, 40, 5}, {0, 50, 5}))[0].stroke, 4U);
}

TEST(Assembly, StaysLevelBetweenUprightToolpaths) {
    Assembly job({.lift = 4});
    job.begin();
    job.add(bead(0, {0, 0, 1}, {10, 0, 1}));
    job.begin();
    const auto out = job.add(bead(0, {0, 30, 5}, {0, 40, 5}));
    const std::vector<Vec3> way{{10, 0, 1}, {10, 0, 5}, {0, 30, 9}, {0, 30, 5}};
    EXPECT_EQ(out[0].points, way);
    EXPECT_TRUE(out[0].normals.empty());
}

TEST(Assembly, GoesFromSideToSideAboveAllThatWasLaid) {
    Assembly job({.lift = 4});
    job.begin();
    job.add(bead(0, {0, 0, 1}, {10, 0, 50})); // a core, 50 high
    for (const double side : {1.0, -1.0}) {
        job.begin();
        Span patch = bead(0, {side * 9, 0, 20}, {side * 9, 0, 30});
        patch.normals = {{side, 0, 0}, {side, 0, 0}};
        const auto out = job.add(patch);
        ASSERT_EQ(out.size(), 2U);
        const Span& travel = out[0];
        for (const std::size_t i : {3, 4}) { // across
            EXPECT_GE(travel.points[i].z, 54);
            EXPECT_EQ(travel.normals[i], (Vec3{0, 0, 1}));
        }
        EXPECT_EQ(travel.points[2].xy(), travel.points[3].xy());
        EXPECT_EQ(travel.points[4].xy(), travel.points[5].xy());
        EXPECT_EQ(travel.normals.back(), (Vec3{side, 0, 0}));
    }
}

TEST(Assembly, PlacesWhatItTakes) {
    Assembly job({.place = mesh::rigid({90, 0, 0}, {1, 2, 3})}); // y becomes z
    job.begin();
    Span patch = bead(0, {0, 10, 0}, {5, 10, 0});
    patch.normals = {{0, 1, 0}, {0, 1, 0}};
    const auto turned = job.add(patch)[0];
    EXPECT_EQ(turned.points, (std::vector<Vec3>{{1, 2, 13}, {6, 2, 13}}));
    EXPECT_EQ(turned.normals, (std::vector<Vec3>(2, {0, 0, 1})));
    const auto flat = job.add(bead(1, {0, 0, 1}, {5, 0, 1})).back();
    EXPECT_EQ(flat.normals, (std::vector<Vec3>(2, {0, -1, 0})));
    Assembly moved({.place = mesh::rigid({0, 0, 0}, {1, 2, 3.3})});
    moved.begin();
    EXPECT_TRUE(moved.add(bead(1, {0, 0, 1}, {5, 0, 1}))[0].normals.empty()) << "moved only, it stays upright";
}

TEST(Assembly, GivesEachToolpathItsTool) {
    Assembly job({.lift = 4, .tools = {0, 2}});
    std::vector<std::uint32_t> beads, travels;
    for (int k = 0; k < 3; ++k) {
        job.begin();
        Span span = bead(0, {0, 9.0 * k, 1}, {10, 9.0 * k, 1});
        span.tool = 7;
        for (const Span& s : job.add(span)) (s.role == Role::travel ? travels : beads).push_back(s.tool);
    }
    EXPECT_EQ(beads, (std::vector<std::uint32_t>{0, 2, 2}));
    EXPECT_EQ(travels, (std::vector<std::uint32_t>{2, 2})); // each that of the bead behind it
    Assembly own({.lift = 4});
    own.begin();
    Span span = bead(0, {0, 0, 1}, {10, 0, 1});
    span.tool = 7;
    EXPECT_EQ(own.add(span)[0].tool, 7U);
}

} // namespace
} // namespace filum::toolpath
