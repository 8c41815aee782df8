#include "stressfield/stencil.hpp"

#include "parts.hpp"

#include <gtest/gtest.h>

namespace filum::stressfield {
namespace {

// Samples at jittered places of a grid over [-1, size + 1]^2 at height z.
void scatter(std::vector<Vec3>& out, double size, double spacing, double z, Dice& dice) {
    for (double y = -1; y <= size + 1; y += spacing)
        for (double x = -1; x <= size + 1; x += spacing)
            out.push_back({x + 0.4 * spacing * dice(), y + 0.4 * spacing * dice(), z});
}

TEST(Cloud, AffineFieldsAreExact) {
    const auto s = square(7, 10);
    std::vector<Vec3> points;
    Dice dice;
    scatter(points, 10, 1.1, 0, dice);
    std::vector<double> f;
    for (const auto& p : points) f.push_back(3 + 2 * p.x - 5 * p.y);
    const auto stencils = in_cloud(s, points, 0, 1);
    for (std::size_t v = 0; v < s.vertices.size(); ++v)
        EXPECT_NEAR(value(stencils, v, f), 3 + 2 * s.vertices[v].x - 5 * s.vertices[v].y, 1e-3);
}

// Inside the samples three of them speak, those of the Delaunay triangle: no value lies beyond theirs, and no other
// sample within the circle through them.
TEST(Cloud, TheThreeAboutAVertexSpeak) {
    const auto s = square(9, 10);
    std::vector<Vec3> points;
    Dice dice;
    scatter(points, 10, 1.1, 0, dice);
    const auto stencils = in_cloud(s, points, 0, 1);
    for (std::size_t v = 0; v < s.vertices.size(); ++v) {
        std::vector<Vec3> corners;
        for (std::uint32_t k = stencils.start[v]; k < stencils.start[v + 1]; ++k) {
            EXPECT_GE(stencils.weight[k], 0);
            if (stencils.weight[k] > 0) corners.push_back(points[stencils.sample[k]]);
        }
        ASSERT_EQ(corners.size(), 3);
        const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
        const double twice = 2 * (a.x * b.y - a.y * b.x), aa = dot(a, a), bb = dot(b, b);
        const Vec3 centre = corners[0] + Vec3{(b.y * aa - a.y * bb) / twice, (a.x * bb - b.x * aa) / twice, 0};
        for (const Vec3& p : points) EXPECT_GE(distance(p, centre), distance(corners[0], centre) - 1e-6);
    }
}

TEST(Cloud, ASampleAtAVertexSpeaksAlone) {
    const auto s = square(4, 4);
    const auto stencils = in_cloud(s, s.vertices, 0, 1);
    for (std::uint32_t v = 0; v < s.vertices.size(); ++v) {
        EXPECT_EQ(stencils.gap[v], 0);
        for (std::uint32_t k = stencils.start[v]; k < stencils.start[v + 1]; ++k)
            EXPECT_EQ(stencils.weight[k], stencils.sample[k] == v ? 1 : 0);
    }
}

// A wall far thinner than the samples are apart, whose other side must not be heard.
TEST(Cloud, TheOtherSideOfAThinWallIsNotHeard) {
    for (const double wall : {0.2, 0.5, 3.0}) {
        const auto s = square(9, 10);
        std::vector<Vec3> points;
        Dice dice;
        scatter(points, 10, 1, 0, dice);
        const std::size_t front = points.size();
        scatter(points, 10, 1, -wall, dice);
        const auto stencils = in_cloud(s, points, wall < 0.3 ? 0.1 : 0, 1);
        for (std::size_t v = 0; v < s.vertices.size(); ++v) {
            ASSERT_LT(stencils.start[v], stencils.start[v + 1]);
            for (std::uint32_t k = stencils.start[v]; k < stencils.start[v + 1]; ++k)
                ASSERT_LT(stencils.sample[k], front) << "wall " << wall;
        }
    }
}

// Both sides belong to the surface: only normals tell them apart.
TEST(Cloud, BothSidesOfAThinWall) {
    auto up = square(9, 10);
    mesh::Mesh m{up.vertices, up.triangles};
    const auto n = static_cast<std::uint32_t>(m.vertices.size());
    for (std::uint32_t v = 0; v < n; ++v) m.vertices.push_back(up.vertices[v] - Vec3{0, 0, 0.3});
    for (const auto& t : up.triangles) m.triangles.push_back({t[0] + n, t[2] + n, t[1] + n});
    Notes notes;
    const auto s = surface::connect(std::move(m), notes);
    std::vector<Vec3> points;
    Dice dice;
    scatter(points, 10, 1, 0, dice);
    const std::size_t front = points.size();
    scatter(points, 10, 1, -0.3, dice);
    const auto stencils = in_cloud(s, points, 0, 2);
    for (std::size_t v = 0; v < s.vertices.size(); ++v) {
        ASSERT_LT(stencils.start[v], stencils.start[v + 1]);
        for (std::uint32_t k = stencils.start[v]; k < stencils.start[v + 1]; ++k)
            ASSERT_EQ(stencils.sample[k] < front, s.vertices[v].z == 0);
    }
}

TEST(Cloud, AHoleInTheDataStaysUnknown) {
    const auto s = square(20, 20);
    std::vector<Vec3> points;
    Dice dice;
    scatter(points, 20, 1, 0, dice);
    std::erase_if(points, [](const Vec3& p) { return std::hypot(p.x - 10, p.y - 10) < 6; });
    const auto stencils = in_cloud(s, points, 0, 1);
    for (std::size_t v = 0; v < s.vertices.size(); ++v) {
        const double r = std::hypot(s.vertices[v].x - 10, s.vertices[v].y - 10);
        const bool known = stencils.start[v] < stencils.start[v + 1];
        EXPECT_TRUE(known || r <= 7) << r;
        EXPECT_FALSE(known && r < 2) << r;
    }
}

TEST(Cloud, SamplesBeyondASharpRimDoNotCount) {
    const auto s = square(5, 5);
    std::vector<Vec3> points;
    for (double y = 0; y <= 5; y += 0.5) {
        for (double x = 0; x <= 5; x += 0.5) points.push_back({x, y, 0});
        for (double z = 0.5; z <= 5; z += 0.5) points.push_back({5, y, -z}); // a wall that goes down at x = 5
    }
    const auto stencils = in_cloud(s, points, 0, 1);
    for (const auto i : stencils.sample) EXPECT_EQ(points[i].z, 0);
}

TEST(Cloud, ThreadsDoNotMatter) {
    const auto s = square(60, 10);
    std::vector<Vec3> points;
    Dice dice;
    scatter(points, 10, 0.3, 0, dice);
    const auto one = in_cloud(s, points, 0, 1), eight = in_cloud(s, points, 0, 8);
    EXPECT_EQ(one.sample, eight.sample);
    EXPECT_EQ(one.weight, eight.weight);
}

} // namespace
} // namespace filum::stressfield
