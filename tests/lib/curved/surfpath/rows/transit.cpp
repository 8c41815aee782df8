// Ways along rims: what is counted is what is laid.
#include "surfpath/rows/transit.hpp"

#include "geom/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace filum::surfpath {

using namespace rows;
namespace {

constexpr double kRadius = 20; // mm, of the rim

Vec3 on_rim(double angle) { return {kRadius * std::cos(angle), kRadius * std::sin(angle), 0}; }

Inset round_rim() {
    Inset out;
    Line ring{{}, true};
    for (int i = 0; i < 720; ++i) ring.places.push_back({0, on_rim(i * std::numbers::pi / 360)});
    out.ways.push_back(surface::curve::arc_lengths(ring));
    out.rings.push_back(std::move(ring));
    return out;
}

// From one place of the rim by way of the middle to another.
Row across(double from, double to) {
    Row out{{{{0, on_rim(from)}, {0, {0, 0, 0}}, {0, on_rim(to)}}, false}, 0, {}, {}};
    out.begin = {0, from * kRadius};
    out.end = {0, to * kRadius};
    return out;
}

TEST(Transit, AWayAlongTheRimPastBothEndsOfARowDoesNotTakeTheRow) {
    Rows rows;
    rows.inset = round_rim();
    rows.rows = {across(1, 1.3), across(0.5, 3), across(1.8, 4)};
    const auto way = Transits(rows).shortest(2, 4); // from 0.5 to 1.8, past 1 and 1.3
    ASSERT_TRUE(way.has_value());
    EXPECT_NEAR(way->length, 1.3 * kRadius, 0.01);
    double laid = 0;
    for (const Line& l : way->stretches) laid += surface::curve::length(l);
    EXPECT_NEAR(laid, way->length, 0.01);
}

TEST(Transit, ARowThatIsShorterThanTheRimIsTaken) {
    Rows rows;
    rows.inset = round_rim();
    rows.rows = {across(0.2, 3), across(0.1, 6), across(3.1, 4.5)};
    const auto way = Transits(rows).shortest(2, 4); // from 0.1 to 3.1, half round
    ASSERT_TRUE(way.has_value());
    EXPECT_NEAR(way->length, (2 + 0.2) * kRadius, 0.01);
    double laid = 0;
    for (const Line& l : way->stretches) laid += surface::curve::length(l);
    EXPECT_NEAR(laid, way->length, 0.01);
}

// Ten chains on a line, in no order, every other one the wrong way round: one after the other.
TEST(Transit, ATourOfManyChainsTakesTheShortWays) {
    const std::vector<std::uint32_t> place{3, 8, 0, 5, 9, 1, 7, 2, 6, 4}; // along the line
    const auto at = [&](std::size_t end) {
        const bool second = (end % 2 == 1) != (place[end / 2] % 2 == 1);
        return 10.0 * place[end / 2] + (second ? 9 : 0);
    };
    const std::size_t n = 2 * place.size();
    std::vector<std::vector<double>> length(n, std::vector<double>(n));
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b) length[a][b] = std::abs(at(a) - at(b));
    const auto order = tour(length);
    ASSERT_EQ(order.size(), place.size());
    double ways = 0;
    for (std::size_t i = 1; i < order.size(); ++i)
        ways += length[2 * order[i - 1].chain + (order[i - 1].reversed ? 0 : 1)]
                      [2 * order[i].chain + (order[i].reversed ? 1 : 0)];
    EXPECT_NEAR(ways, 9, 1e-9);
}

} // namespace
} // namespace filum::surfpath
