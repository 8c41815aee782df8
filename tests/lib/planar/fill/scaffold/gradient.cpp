#include "fill/scaffold/gradient.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace filum::fill::scaffold {

TEST(Gradient, OneNumberHoldsEverywhere) {
    const Gradient g = parse_gradient("60", "porosity", 1, 99);
    for (const double z : {-1.0, 0.0, 5.0, 100.0}) EXPECT_EQ(g.at(z), 60);
    EXPECT_FALSE(parse_gradient("", "porosity", 1, 99).given());
}

TEST(Gradient, ValuesAreLinearBetweenHeights) {
    const Gradient g = parse_gradient("40@1,80@5,60@6", "porosity", 1, 99);
    EXPECT_EQ(g.at(0), 40);
    EXPECT_EQ(g.at(1), 40);
    EXPECT_EQ(g.at(3), 60);
    EXPECT_EQ(g.at(5), 80);
    EXPECT_EQ(g.at(5.5), 70);
    EXPECT_EQ(g.at(7), 60);
}

TEST(Gradient, RefusesWhatIsNone) {
    for (const char* text : {"x", "40@", "@3", "40,80", "40@1,80", "80@5,40@1", "40@1,40@1", "0.5", "100", "40@0,",
                             "nan", "40@0,80@inf", ","})
        EXPECT_THROW(static_cast<void>(parse_gradient(text, "porosity", 1, 99)), Error) << text;
}

TEST(Gradient, PoresGiveTheSpacing) {
    EXPECT_FALSE(Pores("", "").given());
    EXPECT_DOUBLE_EQ(Pores("0.5", "").spacing(0.4, 3), 0.9);
    EXPECT_DOUBLE_EQ(Pores("", "50@0,75@10").spacing(0.4, 0), 0.8);
    EXPECT_DOUBLE_EQ(Pores("", "50@0,75@10").spacing(0.4, 10), 1.6);
}

} // namespace filum::fill::scaffold
