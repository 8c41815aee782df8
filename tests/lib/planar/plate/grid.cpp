#include "plate/grid.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace filum::plate {
namespace {

TEST(Grid, PlatesHaveTheirWellsInTheMiddle) {
    for (const std::int64_t wells : {6, 12, 24, 48, 96}) {
        const Grid grid = well_plate(wells);
        EXPECT_EQ(grid.size(), static_cast<std::size_t>(wells));
        Vec2 sum;
        for (std::size_t k = 0; k < grid.size(); ++k) sum = sum + middle(grid, k);
        EXPECT_NEAR(norm(sum - static_cast<double>(wells) * grid.shift), 0, 1e-6);
        const Vec2 first = middle(grid, 0);
        EXPECT_LT(first.x, 0);
        EXPECT_GT(first.y, 0);
        // A1 of Corning's plates, from the left and from the back of a plate of 127.76 x 85.48 mm
        const double left = 127.76 / 2 + first.x, back = 85.48 / 2 - first.y;
        const double expected[][3] = {
            {6, 24.76, 23.19}, {12, 24.94, 16.79}, {24, 17.48, 13.79}, {48, 18.16, 10.02}, {96, 14.38, 11.24}};
        for (const auto& e : expected)
            if (static_cast<std::int64_t>(e[0]) == wells) {
                EXPECT_NEAR(left, e[1], 0.1) << wells;
                EXPECT_NEAR(back, e[2], 0.1) << wells;
            }
    }
}

TEST(Grid, NamesAreRowsByLettersFromTheBack) {
    const Grid grid = well_plate(12);
    EXPECT_EQ(well_name(grid, 0), "A1");
    EXPECT_EQ(well_name(grid, 3), "A4");
    EXPECT_EQ(well_name(grid, 11), "C4");
    EXPECT_EQ(wells_named(grid, "b3,A1"), (std::vector<std::size_t>{0, 6}));
    EXPECT_EQ(wells_named(grid, "").size(), 12U);
    EXPECT_EQ(well_name(parse_grid("1x30", {1}), 26), "AA1");
    EXPECT_THROW(wells_named(grid, "D1"), Error);
    EXPECT_THROW(wells_named(grid, "A1,,B1"), Error);
}

TEST(Grid, WrongTextsAreRefused) {
    for (const char* text : {"", "4", "4x", "x3", "0x3", "4x3x2", "-1x2", "4.5x3", "4x9999"})
        EXPECT_THROW(parse_grid(text, {20}), Error) << text;
    EXPECT_THROW(parse_grid("4x3", {}), Error);
    EXPECT_THROW(well_plate(13), Error);
    const Grid grid = parse_grid("4X3", {20, 30});
    EXPECT_EQ(grid.columns, 4U);
    EXPECT_EQ(grid.rows, 3U);
    EXPECT_EQ(middle(grid, 0), (Vec2{-30, 30}));
}

} // namespace
} // namespace filum::plate
