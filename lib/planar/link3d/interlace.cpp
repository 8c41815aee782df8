#include "link3d/interlace.hpp"

#include "base/mix.hpp"

#include <algorithm>
#include <cmath>

namespace filum::link3d {

namespace {

constexpr double kStartStep = 3.6;     // bead widths along the curve; more than kApart, because curves bend
constexpr double kGolden = 0.38196601; // 1 - 1 / golden ratio
constexpr double kSpread = 9.6; // bead widths that golden starts spread over: kGolden times it is above kStartStep
constexpr double kRandom = 12;  // bead widths that random starts spread over

} // namespace

double start_offset(Interlace scheme, std::uint32_t layer, double before, std::uint64_t& state) {
    if (scheme == Interlace::alternate) return layer % 2 == 0 ? 0 : kStartStep;
    if (scheme == Interlace::golden) return kSpread * std::fmod(layer * kGolden, 1.0);
    if (scheme == Interlace::none) return 0;
    // Uniform over the offsets that are far enough from the one before.
    const double lo = std::max(0.0, before - kStartStep), hi = std::min(kRandom, before + kStartStep);
    const double at = next_share(state) * (lo + kRandom - hi);
    return at < lo ? at : at - lo + hi;
}

} // namespace filum::link3d
