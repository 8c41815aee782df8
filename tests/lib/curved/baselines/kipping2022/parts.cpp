// What the algorithms are made of.
#include "baselines/kipping2022/path.hpp"
#include "baselines/kipping2022/seed.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::baselines::kipping2022 {
namespace {

TEST(Smoothed, KeepsPolynomialsOfItsDegreeUpToTheEnds) {
    for (const std::size_t degree : {0U, 1U, 2U, 3U, 5U}) {
        const auto value = [&](double x) {
            double sum = 0;
            for (std::size_t k = 0; k <= degree; ++k) sum += std::pow(x / 10, k) * (k % 2 == 0 ? 1.5 : -2);
            return sum;
        };
        Points points;
        for (int i = 0; i < 25; ++i) points.push_back({value(i), -value(i), 1});
        const Points out = smoothed(points, 9, degree);
        for (std::size_t i = 0; i < points.size(); ++i)
            EXPECT_LT(distance(out[i], points[i]), 1e-9) << degree << " " << i;
    }
}

// The weights in the table of Savitzky and Golay 1964: quadratic, 5 points.
TEST(Smoothed, WeighsAsPublished) {
    Points points(11);
    points[5].x = 35;
    const Points out = smoothed(points, 5, 2);
    const double want[] = {0, 0, 0, -3, 12, 17, 12, -3, 0, 0, 0};
    for (std::size_t i = 0; i < 11; ++i) EXPECT_NEAR(out[i].x, want[i], 1e-9) << i;
}

TEST(Smoothed, CutsItsWindowToShortLines) {
    const Points points = {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}};
    EXPECT_EQ(smoothed(points, 1, 0), points);
    EXPECT_EQ(smoothed(points, 9, 2), points);
    const Points straight = smoothed(points, 9, 1); // of the first three and the last three points
    EXPECT_NEAR(straight[0].y, 1.0 / 3, 1e-12);
    EXPECT_NEAR(straight[3].y, 2.0 / 3, 1e-12);
}

TEST(Resampled, IsEvenAlongTheWay) {
    const Points corner = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}};
    const Points out = resampled(corner, false, 0.5);
    ASSERT_EQ(out.size(), 9U);
    EXPECT_EQ(out[7], (Vec3{3, 0.5, 0}));
    EXPECT_EQ(out.back(), corner.back());
    const Points square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const Points round = resampled(square, true, 0.5);
    ASSERT_EQ(round.size(), 8U);
    EXPECT_LT(distance(round[7], {0, 0.5, 0}), 1e-12);
    EXPECT_EQ(resampled(square, true, 100).size(), 3U);
}

TEST(Seed, ChainsSegmentsAndTellsTheirPlane) {
    const Surface s = rectangle(20, 10);
    Notes notes;
    auto sources = geodesic::named_sources(s, "plane:1,0.5,0,9", notes);
    std::mt19937 random(1);
    for (std::size_t i = sources.segments.size(); i > 1; --i)
        std::swap(sources.segments[i - 1], sources.segments[random() % i]);
    const auto lines = seed_lines(sources);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_FALSE(lines[0].closed);
    EXPECT_NEAR(length(lines[0].points, false), std::hypot(10, 5), 1e-9);
    const auto plane = plane_of(s, sources);
    ASSERT_TRUE(plane);
    EXPECT_NEAR(std::abs(dot(plane->normal, Vec3{1, 0.5, 0})), std::hypot(1, 0.5), 1e-9);
    const auto rims = seed_lines(geodesic::named_sources(holed(10, 4), "boundary", notes));
    ASSERT_EQ(rims.size(), 2U);
    EXPECT_TRUE(rims[0].closed && rims[1].closed);
    EXPECT_FALSE(plane_of(s, geodesic::named_sources(s, "vertex:0", notes)));
    EXPECT_FALSE(plane_of(zone(10, 0.3, 1), geodesic::named_sources(zone(10, 0.3, 1), "boundary", notes)));
}

} // namespace
} // namespace filum::baselines::kipping2022
