// Gives the beads of a region exactly the volume of the region.
#pragma once

#include "base/note.hpp"
#include "toolpath/path.hpp"

#include <array>
#include <cstdint>

namespace filum::fill {

// How much material the beads of a region hold.
enum class Volume : std::uint8_t {
    beads, // as wide as the distance between their middle lines
    exact, // the area of the region times its height
};
inline constexpr std::array kVolumeNames{"beads", "exact"};

// The largest change of a bead's width, as a share of it. The section of a bead in a program may differ as much.
inline constexpr double kMostChange = 0.05;

// Multiplies all widths of `paths` by one factor, so that the beads cover as much area as the region has. Beads that
// change lanes lie closer than their width and hold too much; rounded corners hold too little. If the factor would
// differ from 1 by more than kMostChange, it is limited, and a note gives the area
// that remains without a bead, or under two.
void make_exact(toolpath::RegionPaths& paths, Notes& notes);

} // namespace filum::fill
