// The vertices around a local maximum of the distance.
#pragma once

#include "baselines/kipping2022/contours.hpp"

namespace filum::baselines::kipping2022 {

// Vertices around the maximum of the part of the surface above the level that contains `from`: those with a value
// within `tolerance` of the greatest, at least `apart` mm from each other, in the order given in rings.hpp. None for
// parts that were queried before (`seen`, per vertex).
Points maximum(const Surface& s, std::span<const double> values, double level, std::uint32_t from, double tolerance,
               double apart, std::vector<char>& seen);

} // namespace filum::baselines::kipping2022
