#include "fill/join/crossings.hpp"

#include "../pattern_check.hpp"

#include <random>

namespace filum::fill {

using namespace join;

namespace {

double length(const toolpath::Curve& c) {
    double out = 0;
    for (std::size_t i = 0; i < c.points.size(); ++i)
        out += geom::distance(c.points[i], c.points[(i + 1) % c.points.size()]);
    return out;
}

toolpath::Curve closed(std::vector<geom::Vec2> points) {
    toolpath::Curve out;
    out.closed = true;
    out.width.assign(points.size(), 0.4);
    out.points = std::move(points);
    return out;
}

TEST(Uncross, AnEightTurnsBackWhereItCrossed) {
    std::vector<toolpath::Curve> curves{closed({{0, 0}, {2, 2}, {4, 0}, {4, 2}, {2, 0}, {0, 2}})};
    const double before = length(curves[0]);
    ASSERT_GT(test::crossings(curves), 0U);
    Notes notes;
    EXPECT_EQ(uncross(curves, 0.4, notes), 0U);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(test::crossings(curves), 0U);
    EXPECT_NEAR(length(curves[0]), before, 1e-9);
}

TEST(Uncross, TwoThatCrossBecomeOne) {
    std::vector<toolpath::Curve> curves{closed({{0, 0}, {3, 0}, {3, 3}, {0, 3}}),
                                        closed({{2, 1}, {5, 1}, {5, 2}, {2, 2}})};
    Notes notes;
    EXPECT_EQ(uncross(curves, 0.4, notes), 0U);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_NEAR(length(curves[0]), 12 + 8, 1e-9);
}

// Polygons through random points cross themselves everywhere: what comes out crosses nothing and is as long.
TEST(Uncross, RandomPolygons) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        std::mt19937 random(seed);
        const auto uniform = [&] { return 20.0 * random() / 4294967296.0; };
        std::vector<toolpath::Curve> curves;
        double before = 0;
        for (int c = 0; c < 3; ++c) {
            std::vector<geom::Vec2> points;
            for (int k = 0; k < 12; ++k) points.push_back({uniform(), uniform()});
            curves.push_back(closed(points));
            before += length(curves.back());
        }
        Notes notes;
        EXPECT_EQ(uncross(curves, 2, notes), 0U) << seed;
        EXPECT_EQ(test::crossings(curves), 0U) << seed;
        double after = 0;
        for (const auto& c : curves) {
            ASSERT_EQ(c.points.size(), c.width.size());
            after += length(c);
        }
        EXPECT_NEAR(after, before, 0.001 * before) << seed;
    }
}

} // namespace
} // namespace filum::fill
