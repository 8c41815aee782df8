#include "base/number.hpp"
#include "base/error.hpp"
#include "base/shell.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace filum {
namespace {

// printf's digits, with the zeros behind the point and the sign of zero taken off.
std::string by_printf(double v, int decimals) {
    std::array<char, 512> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, v);
    std::string out = buffer.data();
    if (out.find('.') != std::string::npos) {
        while (out.back() == '0') out.pop_back();
        if (out.back() == '.') out.pop_back();
    }
    return out == "-0" ? "0" : out;
}

TEST(FixedText, IsPrintfWithoutTheZeros) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 200'000; ++i) {
        const int decimals = static_cast<int>(random() % 7);
        const double v = unit(random) * std::pow(10, static_cast<double>(random() % 8));
        const std::string want = by_printf(v, decimals), got = fixed_text(v, decimals);
        if (got == want) continue;
        // a value within rounding of a half may go the other way, by one unit in the last place
        const double step = std::pow(10.0, -decimals), scaled = std::abs(v) / step;
        ASSERT_LT(std::abs(scaled - std::floor(scaled) - 0.5), 2e-3) << v << " with " << decimals << ": " << got;
        ASSERT_LE(std::abs(std::strtod(got.c_str(), nullptr) - v), step * 0.502);
    }
}

TEST(FixedText, HasNoExponentNoMinusZeroAndNoUselessZeros) {
    EXPECT_EQ(fixed_text(-0.0, 3), "0");
    EXPECT_EQ(fixed_text(-1e-9, 3), "0");
    EXPECT_EQ(fixed_text(1e-9, 9), "0.000000001");
    EXPECT_EQ(fixed_text(1.5, 0), "2");
    EXPECT_EQ(fixed_text(100, 3), "100");
    EXPECT_EQ(fixed_text(-0.05, 2), "-0.05");
    EXPECT_EQ(fixed_text(1e20, 2), "100000000000000000000");
    EXPECT_EQ(fixed_text(-1e17, 2), "-100000000000000000");
}

TEST(ShortestText, ReadsBackAsTheSameValue) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 100'000; ++i) {
        const double v = std::bit_cast<double>(random());
        if (!std::isfinite(v)) continue;
        const std::string text = shortest_text(v);
        ASSERT_EQ(std::strtod(text.c_str(), nullptr), v);
        ASSERT_EQ(text.find('e'), std::string::npos);
    }
}

TEST(ParseNumber, ADecimalCommaIsNamed) {
    const auto message = [](const char* text) {
        try {
            parse_number(text, "--size");
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_EQ(message("0,25"), "cannot read '0,25' as a number for --size; write 0.25");
    for (const char* other : {"1,2,3", "a,b", ",", "1.000,5"})
        EXPECT_EQ(message(other).find("write"), std::string::npos) << other;
}

TEST(ParseNumber, TakesWholeNumbersOfAnyFormAndNothingElse) {
    EXPECT_EQ(parse_number("1.5", "x"), 1.5);
    EXPECT_EQ(parse_number("-2e-3", "x"), -0.002);
    for (const char* bad : {"", " 1", "1 ", "1,5", "nan", "inf", "1e999", "0x10", "--1", "one"})
        EXPECT_THROW(parse_number(bad, "x"), Error) << bad;
}

TEST(ShellWord, QuotesOnlyWhatNeedsIt) {
    EXPECT_EQ(shell_word("part.stl"), "part.stl");
    EXPECT_EQ(shell_word("--a=1,2"), "--a=1,2");
    EXPECT_EQ(shell_word("a b"), "'a b'");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word(""), "''");
    EXPECT_EQ(shell_word("$(x)"), "'$(x)'");
}

} // namespace
} // namespace filum
