#include "baselines/sun2019/order.hpp"

#include <gtest/gtest.h>

namespace filum::baselines::sun2019 {

using sequence::Order;

namespace {

struct Square {
    std::uint32_t layer;
    double x, side;
};

std::vector<polygon::Region> squares(const std::vector<Square>& all) {
    std::vector<polygon::Region> out;
    for (const auto& s : all) {
        polygon::Region r;
        r.id = static_cast<std::uint32_t>(out.size());
        r.layer = s.layer;
        r.area = s.side * s.side;
        r.loops.add(std::vector<geom::Vec2>{{s.x, 0}, {s.x + s.side, 0}, {s.x + s.side, s.side}, {s.x, s.side}});
        out.push_back(std::move(r));
    }
    return out;
}

TEST(Sun2019Order, LargestOfTheFirstLayerThenTheNearest) {
    // the largest is in the middle; from there 3 mm to the right and 4 to the left
    EXPECT_EQ(order(squares({{0, 0, 1}, {0, 5, 3}, {0, 11, 2}})), (Order{1, 2, 0}));
}

TEST(Sun2019Order, NextLayerBeginsAboveTheLast) {
    const auto regions = squares({{0, 0, 2}, {0, 9, 1}, {1, 0, 2}, {1, 9, 1}, {2, 0, 2}, {2, 9, 1}});
    EXPECT_EQ(order(regions), (Order{0, 1, 3, 2, 4, 5}));
}

TEST(Sun2019Order, TiesGoToTheLargerThenTheFirst) {
    EXPECT_EQ(order(squares({{0, 10, 4}, {0, 5, 3}, {0, 16, 3}, {0, 0, 3}})), (Order{0, 1, 3, 2}));
    EXPECT_EQ(order(squares({{0, 10, 4}, {0, 6, 2}, {0, 16, 3}})), (Order{0, 2, 1}));
}

TEST(Sun2019Order, Nothing) { EXPECT_TRUE(order({}).empty()); }

} // namespace
} // namespace filum::baselines::sun2019
