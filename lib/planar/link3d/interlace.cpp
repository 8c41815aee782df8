#include "link3d/interlace.hpp"

#include <cmath>

namespace filum::link3d {

namespace {

constexpr double kStartStep = 3.6;     // bead widths along the curve; more than kApart, because curves bend
constexpr double kGolden = 0.38196601; // 1 - 1 / golden ratio
constexpr double kSpread = 9.6; // bead widths that golden starts spread over: kGolden times it is above kStartStep

} // namespace

double start_offset(Interlace scheme, std::uint32_t layer) {
    if (scheme == Interlace::alternate) return layer % 2 == 0 ? 0 : kStartStep;
    if (scheme == Interlace::golden) return kSpread * std::fmod(layer * kGolden, 1.0);
    return 0;
}

} // namespace filum::link3d
