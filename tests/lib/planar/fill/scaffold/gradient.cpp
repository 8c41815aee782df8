#include "fill/scaffold/gradient.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace filum::fill::scaffold {

namespace {

double at(const Gradient& g, double z) { return g.at({0, 0, z}, true); }

} // namespace

TEST(Gradient, OneNumberHoldsEverywhere) {
    const Gradient g = parse_gradient("60", "porosity", 1, 99);
    for (const double z : {-1.0, 0.0, 5.0, 100.0}) EXPECT_EQ(at(g, z), 60);
    EXPECT_FALSE(parse_gradient("", "porosity", 1, 99).given());
}

TEST(Gradient, ValuesAreLinearBetweenHeights) {
    const Gradient g = parse_gradient("40@1,80@5,60@6", "porosity", 1, 99);
    EXPECT_EQ(at(g, 0), 40);
    EXPECT_EQ(at(g, 1), 40);
    EXPECT_EQ(at(g, 3), 60);
    EXPECT_EQ(at(g, 5), 80);
    EXPECT_EQ(at(g, 5.5), 70);
    EXPECT_EQ(at(g, 7), 60);
}

TEST(Gradient, RefusesWhatIsNone) {
    for (const char* text : {"q", "40@", "@3", "40,80", "40@1,80", "80@5,40@1", "40@1,40@1", "0.5", "100", "40@0,",
                             "nan", "40@0,80@inf", ","})
        EXPECT_THROW(static_cast<void>(parse_gradient(text, "porosity", 1, 99)), Error) << text;
}

TEST(Gradient, PoresGiveTheSpacing) {
    EXPECT_FALSE(Pores("", "").given());
    EXPECT_DOUBLE_EQ(Pores("0.5", "").spacing(0.4, {0, 0, 3}, true), 0.9);
    EXPECT_DOUBLE_EQ(Pores("", "50@0,75@10").spacing(0.4, {0, 0, 0}, true), 0.8);
    EXPECT_DOUBLE_EQ(Pores("", "50@0,75@10").spacing(0.4, {0, 0, 10}, true), 1.6);
}

TEST(Gradient, FormulasDependOnThePlace) {
    const Gradient g = parse_gradient("0.3 + 0.05 * r + 0.01 * z", "pore-size", 0.001, 1);
    EXPECT_TRUE(g.within_layers());
    EXPECT_DOUBLE_EQ(g.at({3, 4, 10}, true), 0.65);
    EXPECT_THROW(static_cast<void>(g.at({30, 40, 0}, true)), Error);
    EXPECT_EQ(g.at({30, 40, 0}, false), 1);
    EXPECT_EQ(parse_gradient("sqrt(x)", "pore-size", 0.001, 1).at({-1, 0, 0}, false), 0.001);
    EXPECT_FALSE(parse_gradient("0.3 + 0.05 * z", "pore-size", 0.001, 1).within_layers());
    EXPECT_TRUE(Pores("", "50 + x").within_layers());
}

} // namespace filum::fill::scaffold
