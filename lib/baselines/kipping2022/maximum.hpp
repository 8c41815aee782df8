// Where the distance is greatest.
#pragma once

#include "baselines/kipping2022/contours.hpp"

namespace filum::baselines::kipping2022 {

// Vertices at the local maximum of the part of the surface that is above the level and holds `from`: those with a value
// within `tolerance` of the greatest there, `apart` mm apart at least, ordered as rings.hpp says.  Parts that were
// asked for before (`seen`, per vertex) give none.
Points maximum(const Surface& s, std::span<const double> values, double level, std::uint32_t from, double tolerance,
               double apart, std::vector<char>& seen);

} // namespace filum::baselines::kipping2022
