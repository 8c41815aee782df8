#include "geom/segment.hpp"
#include "geom/vec.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace filum::geom {
namespace {

struct Random {
    std::mt19937 engine{4};
    std::uniform_real_distribution<double> coordinate{-10, 10};
    Vec2 point() { return {coordinate(engine), coordinate(engine)}; }
};

TEST(Segment, TheNearestPointIsNearerThanAnySample) {
    Random r;
    for (int i = 0; i < 2000; ++i) {
        const Vec2 a = r.point(), b = r.point(), p = r.point();
        const double d = point_segment_distance(a, b, p);
        for (int k = 0; k <= 20; ++k) EXPECT_LE(d, distance(lerp(a, b, k / 20.0), p) + 1e-12);
    }
    EXPECT_EQ(point_segment_distance({1, 1}, {1, 1}, {4, 5}), 5);
}

TEST(Segment, DistancesAreSymmetricAndZeroWhereTheyCross) {
    Random r;
    int crossings = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vec2 a = r.point(), b = r.point(), c = r.point(), d = r.point();
        const double there = segment_distance(a, b, c, d);
        EXPECT_NEAR(there, segment_distance(d, c, b, a), 1e-12);
        EXPECT_EQ(cross_properly(a, b, c, d), cross_properly(d, c, a, b));
        if (cross_properly(a, b, c, d)) {
            EXPECT_EQ(there, 0);
            ++crossings;
        }
        double sampled = 1e300;
        for (int k = 0; k <= 10; ++k) sampled = std::min(sampled, point_segment_distance(a, b, lerp(c, d, k / 10.0)));
        EXPECT_LE(there, sampled + 1e-12);
    }
    EXPECT_GT(crossings, 500);
}

TEST(Segment, TouchingAndOverlappingDoNotCross) {
    EXPECT_TRUE(cross_properly({0, 0}, {2, 2}, {0, 2}, {2, 0}));
    EXPECT_FALSE(cross_properly({0, 0}, {2, 0}, {1, 0}, {1, 5}));
    EXPECT_FALSE(cross_properly({0, 0}, {2, 0}, {1, 0}, {3, 0}));
    EXPECT_FALSE(cross_properly({0, 0}, {1, 0}, {1, 0}, {2, 1}));
}

TEST(Box, DistanceIsThatOfItsNearestPoints) {
    Box2 a, b;
    EXPECT_TRUE(a.empty());
    a.add({0, 0});
    a.add({1, 1});
    b.add({4, 5});
    b.add({6, 7});
    EXPECT_EQ(distance(a, b), 5);
    EXPECT_EQ(distance(a, a), 0);
}

TEST(Vec, OrientIsPositiveToTheLeft) {
    EXPECT_GT(orient({0, 0}, {1, 0}, {0, 1}), 0);
    EXPECT_LT(orient({0, 0}, {1, 0}, {0, -1}), 0);
    EXPECT_EQ(orient({0, 0}, {1, 1}, {2, 2}), 0);
    EXPECT_EQ(left_of({1, 0}), (Vec2{0, 1}));
    EXPECT_EQ(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}), (Vec3{0, 0, 1}));
}

TEST(Vec, AngleAndUnit) {
    EXPECT_NEAR(angle({1, 0, 0}, {-1, 1e-9, 0}), std::acos(-1.0), 1e-8);
    EXPECT_EQ(angle({2, 0, 0}, {5, 0, 0}), 0);
    EXPECT_EQ(unit({0, 0, -4}, {1, 0, 0}), (Vec3{0, 0, -1}));
    EXPECT_EQ(unit({0, 0, 0}, {1, 0, 0}), (Vec3{1, 0, 0}));
    EXPECT_EQ(longest_axis({1, 3, 3}), 1);
}

TEST(Box, InSpace) {
    const Box3 box = box_of(std::array{Vec3{0, 0, 0}, Vec3{1, 2, 3}});
    EXPECT_TRUE(Box3{}.empty());
    EXPECT_EQ(box.size(), (Vec3{1, 2, 3}));
    EXPECT_EQ(distance(box, {4, 6, 3}), 5);
    EXPECT_EQ(distance(box, {0.5, 1, 1}), 0);
    EXPECT_EQ(grown(box, 1).lo, (Vec3{-1, -1, -1}));
    EXPECT_TRUE(meet(box, grown({{2, 2, 3}, {2, 2, 3}}, 1)));
    EXPECT_FALSE(meet(box, {{2, 0, 0}, {3, 1, 1}}));
    Box3 all;
    all.add(box);
    EXPECT_EQ(all.hi, box.hi);
}

} // namespace
} // namespace filum::geom
