#include "link3d/interlace.hpp"

#include <algorithm>
#include <cmath>

namespace filum::link3d {

namespace {

constexpr double kStartStep = 3.6;     // bead widths along the curve, more than kApart: curves bend
constexpr double kGolden = 0.38196601; // 1 - 1 / golden ratio
constexpr double kSpread = 9.6; // bead widths that golden starts spread over: kGolden times it is above kStartStep
constexpr double kRandom = 12;  // bead widths that random starts spread over

// The next number of a generator with the same numbers everywhere (Steele, Lea, Flood: splitmix64), in [0, 1).
double next(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) / 9007199254740992.0;
}

} // namespace

double start_offset(Interlace scheme, std::uint32_t layer, double before, std::uint64_t& state) {
    if (scheme == Interlace::alternate) return layer % 2 == 0 ? 0 : kStartStep;
    if (scheme == Interlace::golden) return kSpread * std::fmod(layer * kGolden, 1.0);
    if (scheme == Interlace::none) return 0;
    // as if drawn until it is far enough from the one before
    const double lo = std::max(0.0, before - kStartStep), hi = std::min(kRandom, before + kStartStep);
    const double at = next(state) * (lo + kRandom - hi);
    return at < lo ? at : at - lo + hi;
}

} // namespace filum::link3d
