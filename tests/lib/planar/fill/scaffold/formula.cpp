#include "fill/scaffold/formula.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace filum::fill::scaffold {
namespace {

const std::vector<std::string> kNames{"x", "y", "r"};

double value(const std::string& text, double x = 0, double y = 0) {
    return Formula(text, kNames, "pore-size")(std::array{x, y, std::hypot(x, y)});
}

TEST(Formula, HasTheValuesOfArithmetic) {
    EXPECT_DOUBLE_EQ(value("0.3 + 0.02 * x", 5), 0.4);
    EXPECT_DOUBLE_EQ(value("2 + 3 * 4 ^ 2"), 50);
    EXPECT_DOUBLE_EQ(value("2 ^ 3 ^ 2"), 512);
    EXPECT_DOUBLE_EQ(value("-2 ^ 2"), -4);
    EXPECT_DOUBLE_EQ(value("2 ^ -1"), 0.5);
    EXPECT_DOUBLE_EQ(value("(1 + 2) * -(3 - 5)"), 6);
    EXPECT_DOUBLE_EQ(value("8 / 4 / 2"), 1);
    EXPECT_DOUBLE_EQ(value("1 - 2 - 3"), -4);
    EXPECT_DOUBLE_EQ(value("max(1, min(x, y)) + r", 3, 4), 8);
    EXPECT_DOUBLE_EQ(value("sqrt(16) + abs(-2) + exp(0) + cos(0) + sin(pi / 2)"), 9);
    EXPECT_DOUBLE_EQ(value("1e-3*x", 1e3), 1);
    EXPECT_DOUBLE_EQ(value("x >= 2 ? 0.3 : 0.4", 1), 0.4);
    EXPECT_DOUBLE_EQ(value("x == y ? 1 : 2", 3, 3), 1);
}

TEST(Formula, KnowsItsVariables) {
    const Formula f("0.3 + y", kNames, "pore-size");
    EXPECT_FALSE(f.uses(0));
    EXPECT_TRUE(f.uses(1));
    EXPECT_FALSE(Formula().given());
}

TEST(Formula, RefusesWhatIsNone) {
    for (const char* text : {"", "x +", "(x", "x)", "1 2", "q", "sin x", "max()", "1, 2", "x ** 2", "1..2", "@",
                             "sqrt()", "inf", "nan", "1e999", "x = 3", "(r=3)+x"})
        EXPECT_THROW(Formula(text, kNames, "pore-size"), Error) << text;
    EXPECT_THROW(Formula(std::string(100000, '('), kNames, "pore-size"), Error);
    EXPECT_THROW(Formula(std::string(100000, '-') + "1", kNames, "pore-size"), Error);
}

TEST(Formula, RandomTextIsReadOrRefused) {
    std::mt19937 random(1);
    const std::string letters = "xyr0123456789.+-*/^(), episqrtmaxn";
    int read = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        std::string text;
        for (std::size_t i = random() % 12; i > 0; --i) text += letters[random() % letters.size()];
        try {
            const Formula f(text, kNames, "pore-size");
            static_cast<void>(f(std::array{1.0, 2.0, 3.0}));
            ++read;
        } catch (const Error&) {
        }
    }
    EXPECT_GT(read, 100);
}

} // namespace
} // namespace filum::fill::scaffold
