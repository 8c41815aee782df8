// Which way the beads run.
#pragma once

#include "metrics/planar/beads.hpp"

#include <array>

namespace filum::metrics::planar {

// share[k]: of the bead length, joins left out, what runs within 7.5 degrees of 15 k degrees from the x axis, either
// way along the line; a segment on the border of two counts for the higher one.  All 0 if there is no bead.
struct Directions {
    static constexpr std::size_t kBins = 12;
    std::array<double, kBins> share{};
};

Directions directions(const Beads& beads);

} // namespace filum::metrics::planar
