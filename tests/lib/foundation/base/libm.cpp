// The functions of lib/foundation/base/libm.cpp, which stand in for those of the C library.
#include "base/mix.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace filum {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = 0x1.921fb54442d18p+1;

// What a function gives, in units in the last place, beside the long double function of the C library.
template <typename Double, typename Exact>
double worst_error(Double function, Exact exact, double from, double to, std::uint64_t seed) {
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const double x = from + (to - from) * next_share(seed);
        const long double right = exact(static_cast<long double>(x));
        const auto near = std::abs(static_cast<double>(right));
        const double unit = std::nextafter(near, kInfinity) - near;
        worst = std::max(worst, static_cast<double>(std::abs(static_cast<long double>(function(x)) - right)) / unit);
    }
    return worst;
}

TEST(Libm, ErrorsAreAsStated) {
    using D = double;
    using L = long double;
    EXPECT_LE(worst_error([](D x) { return std::sin(x); }, [](L x) { return std::sin(x); }, -10, 10, 1), 1);
    EXPECT_LE(worst_error([](D x) { return std::sin(x); }, [](L x) { return std::sin(x); }, -2e6, 2e6, 2), 1);
    EXPECT_LE(worst_error([](D x) { return std::cos(x); }, [](L x) { return std::cos(x); }, -10, 10, 3), 1);
    EXPECT_LE(worst_error([](D x) { return std::tan(x); }, [](L x) { return std::tan(x); }, -10, 10, 4), 2.5);
    EXPECT_LE(worst_error([](D x) { return std::asin(x); }, [](L x) { return std::asin(x); }, -1, 1, 5), 2.5);
    EXPECT_LE(worst_error([](D x) { return std::acos(x); }, [](L x) { return std::acos(x); }, -1, 1, 6), 2.5);
    EXPECT_LE(worst_error([](D x) { return std::atan(x); }, [](L x) { return std::atan(x); }, -20, 20, 7), 1.5);
    EXPECT_LE(
        worst_error([](D x) { return std::atan2(x, -0.7); }, [](L x) { return std::atan2(x, L{-0.7}); }, -20, 20, 8),
        1.5);
    EXPECT_LE(worst_error([](D x) { return std::exp(x); }, [](L x) { return std::exp(x); }, -700, 700, 9), 1);
    EXPECT_LE(worst_error([](D x) { return std::log(x); }, [](L x) { return std::log(x); }, 1e-3, 20, 10), 1.5);
    EXPECT_LE(worst_error([](D x) { return std::log10(x); }, [](L x) { return std::log10(x); }, 1e-3, 2000, 11), 2.5);
    EXPECT_LE(worst_error([](D x) { return std::pow(x, D{1} / 3); }, [](L x) { return std::pow(x, L{D{1} / 3}); }, 1e-3,
                          2000, 12),
              2 + 1.5 * std::log(2000.0) / 3);
}

// The same bits on every processor: a sum over the bits of many results, which no machine may find another.
TEST(Libm, BitsAreTheSameOnEveryProcessor) {
    std::uint64_t sum = 0, seed = 99;
    const auto add = [&sum](double v) { sum = mixed(sum ^ std::bit_cast<std::uint64_t>(v)); };
    for (int i = 0; i < 20000; ++i) {
        const double x = 20 * next_share(seed) - 10, u = 2 * next_share(seed) - 1, p = 1e3 * next_share(seed);
        for (const double v : {std::sin(x), std::cos(x), std::tan(x), std::asin(u), std::acos(u), std::atan(x),
                               std::atan2(x, u), std::exp(x), std::log(p), std::log10(p), std::pow(p, u)})
            add(v);
    }
    EXPECT_EQ(sum, std::uint64_t{1484099206237663249U});
}

TEST(Libm, EdgesAreThoseOfTheStandard) {
    for (const double none :
         {std::sin(kInfinity), std::cos(-kInfinity), std::tan(kInfinity), std::asin(1.1), std::acos(-1.1),
          std::log(-1.0), std::pow(-2.0, 0.5), std::atan2(std::nan(""), 1.0), std::exp(std::nan(""))})
        EXPECT_TRUE(std::isnan(none));
    EXPECT_TRUE(std::signbit(std::sin(-0.0)));
    EXPECT_TRUE(std::signbit(std::atan2(-0.0, 1.0)));
    EXPECT_EQ(std::atan2(0.0, -0.0), kPi);
    EXPECT_EQ(std::atan2(-0.0, -1.0), -kPi);
    EXPECT_EQ(std::atan2(1.0, 0.0), kPi / 2);
    EXPECT_EQ(std::atan2(-kInfinity, -kInfinity), -3 * (kPi / 4));
    EXPECT_EQ(std::atan2(1.0, kInfinity), 0);
    EXPECT_EQ(std::atan2(0x1p1020, 0x1p1020), kPi / 4);
    EXPECT_EQ(std::acos(1.0), 0);
    EXPECT_EQ(std::acos(-1.0), kPi);
    EXPECT_EQ(std::asin(1.0), kPi / 2);
    EXPECT_EQ(std::exp(-kInfinity), 0);
    EXPECT_EQ(std::exp(1000.0), kInfinity);
    EXPECT_GT(std::exp(-745.0), 0); // a number below the normal ones
    EXPECT_EQ(std::log(0.0), -kInfinity);
    EXPECT_EQ(std::log(kInfinity), kInfinity);
    EXPECT_EQ(std::pow(0.0, -1.0), kInfinity);
    EXPECT_EQ(std::pow(-2.0, 3.0), -8);
    EXPECT_EQ(std::pow(0.0, 0.5), 0);
    EXPECT_EQ(std::pow(2.0, -kInfinity), 0);
    EXPECT_EQ(std::pow(-1.0, kInfinity), 1);
    EXPECT_EQ(std::pow(std::nan(""), 0.0), 1);
}

TEST(Libm, PowersOfTenAreExact) {
    double power = 1;
    for (int n = 0; n <= 22; ++n, power *= 10) {
        EXPECT_EQ(std::pow(10.0, n), power);
        EXPECT_EQ(std::pow(10.0, -n), 1 / power);
        EXPECT_EQ(std::log10(power), n);
        EXPECT_EQ(std::log10(1 / power), -n);
    }
}

} // namespace
} // namespace filum
