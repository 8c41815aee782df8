#include "base/density.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace filum;

std::string refusal(double area, double spacing) {
    try {
        check_density(area, spacing, Exit::usage, "--spacing");
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(Density, RefusesMoreLinesThanAStageLays) {
    EXPECT_EQ(refusal(1e6, 0.4), ""); // a square metre of ordinary beads
    EXPECT_EQ(refusal(1200, 0.001),
              "cannot use '0.001' for --spacing: 1200 mm2 would hold more than 10 million squares of that side; give "
              "at least 0.011 mm");
    for (const double area : {1e-3, 1.0, 123.0, 4e7, 1e12}) {
        const std::string text = refusal(area, 1e-9);
        ASSERT_NE(text, "");
        const double least = std::stod(text.substr(text.find("at least ") + 9));
        EXPECT_EQ(refusal(area, least), "") << area; // what it says to give is taken
        EXPECT_LT(least * least * kMostSquares, 1.25 * area);
    }
    EXPECT_NE(refusal(1, 0), "");
    EXPECT_EQ(refusal(0, 1e-9), "");
}

TEST(Density, RefusesBeadsOneOnTheOther) {
    EXPECT_NO_THROW(check_spacing(0.2, 0.4, Exit::bad_input, "a spacing"));
    EXPECT_THROW(check_spacing(0.19, 0.4, Exit::bad_input, "a spacing"), Error);
    EXPECT_THROW(check_spacing(0, 0.4, Exit::bad_input, "a spacing"), Error);
}

} // namespace
