// Start-point interlacing: how far along its curve each layer begins from the start of the column.
#pragma once

#include <cstdint>

namespace filum::link3d {

// The scheme of a column's starts (Sun et al. 2019, 3.3; docs/algorithms/link3d.md#starts-set-apart).
enum class Interlace : std::uint8_t {
    none,      // each layer begins where the one below it ended
    alternate, // two places in turn
    golden,    // spread by the golden section, so that no place repeats
};

// Least distance between the starts of neighbouring layers, in bead widths: three, with room for layers of different
// mean widths.
inline constexpr double kApart = 3.2;

// The distance along the curve from the column's home to the start of a layer, in bead widths: at most 12. The offsets
// of neighbouring layers differ by more than kApart, except with `none`, which gives 0.
double start_offset(Interlace scheme, std::uint32_t layer);

} // namespace filum::link3d
