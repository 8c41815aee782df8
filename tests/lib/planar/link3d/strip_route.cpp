#include "link3d/strip_route.hpp"

#include <gtest/gtest.h>

namespace {

using namespace filum;
using filum::geom::Vec2;

// A narrow loop that is `length` mm long, with its lines 0.8 mm apart.
toolpath::Curve loop(double length) {
    toolpath::Curve c;
    c.closed = true;
    c.points = {{0, 0}, {length, 0}, {length, 0.8}, {0, 0.8}};
    c.width = {0.4};
    return c;
}

std::optional<std::vector<Vec2>> route(const toolpath::Curve& c, Vec2 to) {
    std::vector<std::vector<Vec2>> lines{c.points};
    lines.back().push_back(c.points.front());
    const std::vector<toolpath::Curve> curves{c};
    const link3d::SegmentIndex index(curves);
    return link3d::strip_route(lines, curves, index, c.points[0], 0.4, link3d::kStrips, 1,
                               [&](Vec2 p, int) { return geom::distance(p, to) < 0.5 ? 1 : 0; });
}

TEST(StripRoute, LeadsAlongTheMiddleOfTheStrip) {
    const auto way = route(loop(10), {8, 0.4});
    ASSERT_TRUE(way);
    for (const Vec2 p : *way) EXPECT_LE(std::abs(p.y - 0.4), 0.4);
}

// In the order of the line, 60,000 points in a row would take 10^9 flips, which is minutes.
TEST(StripRoute, ALoopOfTwentyFourMetresTakesNoSquaredTime) {
    auto far = loop(10);
    far.points[1] = {24000, -3000}; // a corner far away, as a forged message has it
    route(far, {8, 0.4});
    EXPECT_TRUE(route(loop(24000), {20000, 0.4}));
}

} // namespace
