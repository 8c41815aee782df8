// Toolpaths one behind the other.
#include "assemble/assemble.hpp"

#include <gtest/gtest.h>

namespace filum::assemble {
namespace {

using geom::Vec3;
using toolpath::Role;
using toolpath::Span;

Span bead(std::uint32_t stroke, Vec3 a, Vec3 b) { return {Role::bead, stroke, 0, 0, {a, b}, {1}, {0.2}, {}}; }

TEST(assemble, numbers_strokes_on_and_travels_along_both_axes) {
    Job job({.lift = 4});
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
    const std::vector<Vec3> way{{20, 0, 1}, {20, 0, 5}, {4, 30, 5}, {0, 30, 5}};
    EXPECT_EQ(out[0].points, way);
    const std::vector<Vec3> axes{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(out[0].normals, axes);
    EXPECT_EQ(job.add(bead(1, {0, 40, 5}, {0, 50, 5}))[0].stroke, 4U);
}

TEST(assemble, gives_each_toolpath_its_tool) {
    Job job({.lift = 4, .tools = {0, 2}});
    std::vector<std::uint32_t> beads, travels;
    for (int k = 0; k < 3; ++k) {
        job.begin();
        Span span = bead(0, {0, 9.0 * k, 1}, {10, 9.0 * k, 1});
        span.tool = 7;
        for (const Span& s : job.add(span)) (s.role == Role::travel ? travels : beads).push_back(s.tool);
    }
    EXPECT_EQ(beads, (std::vector<std::uint32_t>{0, 2, 2}));
    EXPECT_EQ(travels, (std::vector<std::uint32_t>{2, 2})); // each that of the bead behind it
    Job own({.lift = 4});
    own.begin();
    Span span = bead(0, {0, 0, 1}, {10, 0, 1});
    span.tool = 7;
    EXPECT_EQ(own.add(span)[0].tool, 7U);
}

} // namespace
} // namespace filum::assemble
