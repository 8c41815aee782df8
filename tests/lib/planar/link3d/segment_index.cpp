#include "link3d/segment_index.hpp"
#include "curves.hpp"

#include <gtest/gtest.h>

namespace filum::link3d {

using namespace test;

namespace {

std::vector<Curve> some_curves(Random& random) {
    std::vector<Curve> curves{comb({0, 0}, 8, 10), rings({15, 3}, 3, 6), circle({4, 12}, 3, 90)};
    for (int k = 0; k < 30; ++k)
        curves.push_back(
            {false,
             {{20 * random(), 20 * random()}, {20 * random(), 20 * random()}, {20 * random(), 20 * random()}},
             {kWidth}});
    return curves;
}

// Distance by looking at every segment.
double plain_distance(const std::vector<Curve>& curves, Vec2 p, const std::vector<char>& skip) {
    double best = 1e300;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const auto& q = curves[c].points;
        for (std::size_t i = 0; i < q.size() - (curves[c].closed ? 0 : 1); ++i)
            if (skip[c] == 0) best = std::min(best, geom::point_segment_distance(q[i], q[(i + 1) % q.size()], p));
    }
    return best;
}

} // namespace

TEST(SegmentIndex, FindsTheNearestPlaceOfEveryCurve) {
    Random random{1};
    const auto curves = some_curves(random);
    const SegmentIndex index(curves);
    for (int k = 0; k < 2000; ++k) {
        const Vec2 p{24 * random() - 2, 24 * random() - 2};
        std::vector<char> skip(curves.size());
        for (auto& s : skip) s = random() < 0.5 ? 1 : 0;
        skip[static_cast<std::size_t>(k) % skip.size()] = 0;
        const double d = plain_distance(curves, p, skip);
        const auto place = index.nearest(p, std::numeric_limits<double>::infinity(), skip);
        ASSERT_TRUE(place);
        EXPECT_DOUBLE_EQ(place->distance, d);
        EXPECT_EQ(skip[place->curve], 0);
        const auto& q = curves[place->curve].points;
        const Vec2 again = geom::lerp(q[place->segment], q[(place->segment + 1) % q.size()], place->t);
        EXPECT_EQ(again, place->point);
        EXPECT_FALSE(index.nearest(p, d * 0.999 - 1e-9, skip));
        EXPECT_TRUE(index.nearest(p, d, skip)) << "the limit itself is in reach";
    }
}

// Along a curve, forwards and backwards and with jumps, the place lies as near as the nearest one.
TEST(SegmentIndex, FollowsCurves) {
    Random random{5};
    const auto curves = some_curves(random);
    const SegmentIndex index(curves);
    for (const Curve& c : curves) {
        std::optional<Place> at;
        for (int k = 0; k < 400; ++k) {
            const std::size_t n = c.points.size(), i = static_cast<std::size_t>(k < 200 ? k : 400 - k) % n;
            const Vec2 on = geom::lerp(c.points[i], c.points[(i + 1) % n], random());
            const Vec2 p = k % 50 == 7 ? Vec2{20 * random(), 20 * random()} : on; // a jump
            at = index.follow(p, at);
            ASSERT_TRUE(at);
            EXPECT_NEAR(at->distance, index.nearest(p)->distance, 1e-6);
        }
    }
}

TEST(SegmentIndex, TellsWhatIsFree) {
    Random random{2};
    const auto curves = some_curves(random);
    const SegmentIndex index(curves);
    int free = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec2 a{20 * random(), 20 * random()}, b = a + Vec2{random() - 0.5, random() - 0.5};
        double least = 1e300;
        for (const auto& c : curves)
            for (std::size_t i = 0; i < c.points.size() - (c.closed ? 0 : 1); ++i)
                least = std::min(least, geom::segment_distance(a, b, c.points[i], c.points[(i + 1) % c.points.size()]));
        EXPECT_EQ(is_free(index, a, b, 0.05, 0, 0), least > 0.05);
        free += least > 0.05 ? 1 : 0;
    }
    EXPECT_GT(free, 200);
    EXPECT_LT(free, 1800);
}

TEST(SegmentIndex, HoldsNothing) {
    const SegmentIndex none{std::vector<Curve>{}};
    EXPECT_TRUE(none.empty());
    EXPECT_FALSE(none.nearest({0, 0}));
    EXPECT_TRUE(none.extremes().empty());
    EXPECT_TRUE(is_free(none, {0, 0}, {1, 1}, 1, 0, 0));
}

TEST(SegmentCells, AnswersAsTheTreeDoes) {
    Random random{3};
    const auto curves = some_curves(random);
    const SegmentIndex index(curves);
    const SegmentCells cells(curves);
    for (int k = 0; k < 3000; ++k) {
        const Vec2 p{24 * random() - 2, 24 * random() - 2}, q = p + Vec2{2 * random() - 1, 2 * random() - 1};
        const double limit = 3 * random(), margin = random();
        const auto place = index.nearest(p, limit);
        const auto near = cells.nearest(p, limit);
        ASSERT_EQ(place.has_value(), near.has_value()) << k;
        if (near) {
            EXPECT_NEAR(place->distance, near->distance, 1e-12);
            const Place same = index.place(near->segment, 0, p);
            EXPECT_TRUE(same.curve == place->curve && same.segment == place->segment) << k;
        }
        EXPECT_EQ(is_free(index, p, q, margin, 0.2, 0.1), is_free(cells, p, q, margin, 0.2, 0.1)) << k;
    }
}

} // namespace filum::link3d
