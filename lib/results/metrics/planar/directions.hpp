// The distribution of bead directions.
#pragma once

#include "metrics/planar/beads.hpp"

#include <array>

namespace filum::metrics::planar {

// share[k]: fraction of the bead length, without joins, within 7.5 degrees of 15 k degrees from the x axis, in either
// sense; a segment on the border of two bins counts for the higher one. All 0 without beads.
struct Directions {
    static constexpr std::size_t kBins = 12;
    std::array<double, kBins> share{};
};

Directions directions(const Beads& beads);

} // namespace filum::metrics::planar
