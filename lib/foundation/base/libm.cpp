// Functions of libm whose last bit depends on the processor, defined once for all processors.
//
// glibc has several versions of sin, atan2, exp and others, and chooses one when a program starts. Versions for
// processors with fused multiply-add sometimes differ in the last bit from the others. A path that is decided by the
// smaller of two lengths then differs too.
//
// The definitions below replace those of glibc in every program that links this library. They add, multiply and divide
// IEEE doubles in a fixed order, so they give the same bits on every x86-64 processor.
//
// Largest errors found, in units in the last place (tests/lib/foundation/base/libm.cpp): sin, cos, exp 1; log, atan,
// atan2 1.5; tan, asin, acos, log10 2.5. pow: 2 + 1.5 |y log x|, unless its exponent is a small whole number.
//
// Method: the argument is reduced to a short interval, with constants split into two or three parts (Cody and Waite,
// Software Manual for the Elementary Functions, 1980). The Taylor series follows, with a remainder below 2^-56 of the
// value. This file is compiled with -fno-builtin, otherwise a compiler would take the definitions for the functions
// that they replace.
#include <cstdint>
#include <limits>

extern "C" {
double sin(double);
double cos(double);
double tan(double);
double asin(double);
double acos(double);
double atan(double);
double atan2(double, double);
double exp(double);
double log(double);
double log10(double);
double pow(double, double);
float expf(float);
float powf(float, float);
void sincos(double, double*, double*);
// Functions for which libm has only one version, or whose results are exact.
long double sinl(long double);
long double cosl(long double);
double frexp(double, int*);
double ldexp(double, int);
double rint(double);
double trunc(double);
}

namespace filum {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kHalfPi = 0x1.921fb54442d18p+0, kHalfPiRest = 0x1.1a62633145c07p-54;

double root(double v) { return __builtin_sqrt(v); } // one instruction, rounded correctly
double size(double v) { return __builtin_fabs(v); }
double signed_as(double v, double sign) { return __builtin_copysign(v, sign); }
bool odd(double whole) { return whole - 2 * trunc(whole / 2) != 0; }

// The sum of coefficient[k] v^k by Horner's rule.
template <std::size_t n>
double series(double v, const double (&coefficient)[n]) {
    double sum = coefficient[n - 1];
    for (std::size_t k = n - 1; k-- > 0;) sum = sum * v + coefficient[k];
    return sum;
}

// An angle as high + low + quarter * pi / 2, where |high| is at most slightly larger than pi / 4.
struct Angle {
    double high, low;
    int quarter; // 0 to 3
};

// pi / 2 in three parts. The first two have 33 bits, so that 2^20 times them is exact.
constexpr double kFirst = 0x1.921fb544p+0, kSecond = 0x1.0b4611a6p-34, kThird = 0x1.3198a2e037073p-69;
constexpr double kMostAngle = 1 << 20;

Angle reduced(double x) {
    const double n = rint(x * 0x1.45f306dc9c883p-1);
    const double exact = x - n * kFirst, second = n * kSecond, third = n * kThird;
    const double once = exact - second;
    const double rest = ((exact - once) - second) - third;
    const double high = once + rest;
    return {high, (once - high) + rest, static_cast<int>(static_cast<std::int64_t>(n) & 3)};
}

double sine(const Angle& a) {
    static constexpr double of[] = {-1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
                                    -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
    const double z = a.high * a.high;
    return a.high + (a.high * z * series(z, of) + a.low * (1 - z / 2));
}

double cosine(const Angle& a) {
    static constexpr double of[] = {1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
                                    1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
    const double z = a.high * a.high, half = z / 2, most = 1 - half;
    return most + (((1 - most) - half) + (z * z * series(z, of) - a.high * a.low));
}

double turned_sine(const Angle& a, int quarter) {
    const double v = (quarter & 1) != 0 ? cosine(a) : sine(a);
    return (quarter & 2) != 0 ? -v : v;
}

// The arc tangent of a / b as high + low, for 0 <= a <= b with b > 0 and finite.
struct Pair {
    double high, low;
};

Pair arc(double a, double b) {
    // The arc tangents of 0, 1/8, ..., 1 in two parts.
    static constexpr double known[9] = {0x0.0p+0,
                                        0x1.fd5ba9aac2f6ep-4,
                                        0x1.f5b75f92c80ddp-3,
                                        0x1.6f61941e4def1p-2,
                                        0x1.dac670561bb4fp-2,
                                        0x1.1e00babdefeb4p-1,
                                        0x1.4978fa3269ee1p-1,
                                        0x1.700a7c5784634p-1,
                                        0x1.921fb54442d18p-1};
    static constexpr double rest[9] = {0x0.0p+0,
                                       -0x1.cd37686760c17p-59,
                                       0x1.8ab6e3cf7afbdp-57,
                                       -0x1.c63aae6f6e918p-56,
                                       0x1.a2b7f222f65e2p-56,
                                       -0x1.928df287a668fp-58,
                                       0x1.2419a87f2a458p-56,
                                       -0x1.8c34d25aadef6p-56,
                                       0x1.1a62633145c07p-55};
    static constexpr double of[] = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13};
    const int k = static_cast<int>(rint(8 * (a / b)));
    const double c = k / 8.0;
    const double t = k == 0 ? a / b : (a - c * b) / (b + c * a);
    const double z = t * t;
    return {known[k], rest[k] + (t + t * z * series(z, of))};
}

// x^n for whole n with |n| <= 64, by squaring. The result is exact wherever the powers are.
double whole_power(double x, int n) {
    double out = 1, square = x;
    for (int k = n < 0 ? -n : n; k != 0; k >>= 1) {
        if ((k & 1) != 0) out *= square;
        square *= square;
    }
    return n < 0 ? 1 / out : out;
}

constexpr double kMostWhole = 64;

// The logarithm as exponent * log 2 + fraction with |fraction| < 0.35, for x positive and finite.
struct Logarithm {
    double exponent, fraction;
};

Logarithm logarithm(double x) {
    static constexpr double of[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11, 2.0 / 13,
                                    2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21, 2.0 / 23};
    int exponent = 0;
    double m = frexp(x, &exponent);
    if (m < 0x1.6a09e667f3bcdp-1) {
        m *= 2;
        --exponent;
    }
    const double f = m - 1, s = f / (2 + f), z = s * s, half = f * f / 2;
    return {static_cast<double>(exponent), f - (half - s * (half + z * series(z, of)))};
}

constexpr double kLog2 = 0x1.62e42feep-1, kLog2Rest = 0x1.a39ef35793c76p-33; // log 2 in two parts, the first of 32 bits

} // namespace

} // namespace filum

using namespace filum; // NOLINT(google-build-using-namespace): the functions below have no namespace

extern "C" {

double sin(double x) {
    if (size(x) < 0x1p-27 || x != x) return x;
    if (size(x) == kInfinity) return kNone;
    if (size(x) >= kMostAngle) return static_cast<double>(sinl(static_cast<long double>(x)));
    const Angle a = reduced(x);
    return turned_sine(a, a.quarter);
}

double cos(double x) {
    if (x != x) return x;
    if (size(x) == kInfinity) return kNone;
    if (size(x) >= kMostAngle) return static_cast<double>(cosl(static_cast<long double>(x)));
    const Angle a = reduced(x);
    return turned_sine(a, a.quarter + 1);
}

void sincos(double x, double* s, double* c) {
    *s = sin(x);
    *c = cos(x);
}

double tan(double x) {
    if (size(x) < 0x1p-27 || x != x) return x;
    return sin(x) / cos(x);
}

double atan2(double y, double x) {
    if (x != x || y != y) return kNone;
    double a = size(y), b = size(x);
    if (a == kInfinity && b == kInfinity) a = b = 1;
    const bool steep = a > b;
    if (steep) {
        const double swap = a;
        a = b;
        b = swap;
    }
    if (b > 0x1p+1000) {
        a *= 0x1p-60;
        b *= 0x1p-60;
    }
    Pair angle = b == 0 || b == kInfinity ? Pair{0, 0} : arc(a, b);
    if (steep) angle = {kHalfPi - angle.high, kHalfPiRest - angle.low};
    if (__builtin_signbit(x)) angle = {2 * kHalfPi - angle.high, 2 * kHalfPiRest - angle.low};
    return signed_as(angle.high + angle.low, y);
}

double atan(double x) { return size(x) < 0x1p-27 ? x : atan2(x, 1); }

double asin(double x) { return size(x) < 0x1p-27 ? x : size(x) > 1 ? kNone : atan2(x, root((1 - x) * (1 + x))); }

double acos(double x) { return size(x) > 1 ? kNone : atan2(root((1 - x) * (1 + x)), x); }

double exp(double x) {
    static constexpr double of[] = {1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                                    1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                                    1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
    if (x != x) return x;
    if (x > 710) return kInfinity;
    if (x < -746) return 0;
    const double k = rint(x * 0x1.71547652b82fep+0);
    const double high = x - k * kLog2, low = k * kLog2Rest, r = high - low;
    return ldexp(1 + (high - (low - r * r * series(r, of))), static_cast<int>(k));
}

double log(double x) {
    if (x != x || x == kInfinity) return x;
    if (x <= 0) return x == 0 ? -kInfinity : kNone;
    const Logarithm l = logarithm(x);
    return l.exponent * kLog2 + (l.exponent * kLog2Rest + l.fraction);
}

double log10(double x) {
    const double v = log(x) * 0x1.bcb7b1526e50ep-2;
    const double whole = rint(v);
    return size(whole) <= kMostWhole && whole_power(10, static_cast<int>(whole)) == x ? whole : v;
}

double pow(double x, double y) {
    if (y == 0 || x == 1) return 1;
    if (x != x || y != y) return kNone;
    const bool whole = trunc(y) == y;
    if (whole && size(y) <= kMostWhole) return whole_power(x, static_cast<int>(y));
    if (x < 0 && !whole && size(x) != kInfinity) return kNone;
    if (size(x) == 1 && size(y) == kInfinity) return 1;
    const double sign = x < 0 && whole && odd(y) ? -1 : 1;
    const double l = log(size(x));
    return sign * (l == 0 ? 1 : exp(y * l));
}

float expf(float x) { return static_cast<float>(exp(static_cast<double>(x))); }

float powf(float x, float y) { return static_cast<float>(pow(static_cast<double>(x), static_cast<double>(y))); }
}
