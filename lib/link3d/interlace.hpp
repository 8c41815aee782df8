// Start-point interlacing: how far along its curve each layer begins beside where the column began.
#pragma once

#include <cstdint>

namespace filum::link3d {

// The scheme of a column's starts (Sun et al. 2019, 3.3; docs/algorithms/link3d.md#starts-set-apart).
enum class Interlace : std::uint8_t {
    none,      // each layer begins where the one below it ended
    alternate, // at two places in turn
    golden,    // spread by the golden section: no place comes twice
    random,
};

// Neighbouring layers begin at least so many bead widths apart: three, however the mean widths of layers differ.
inline constexpr double kApart = 3.2;

// Bead widths along the curve from the column's home to the start of a layer.  Consecutive layers differ by more than
// kApart; all lie within 12 widths.  `before` is the offset of the layer below; alternate and golden look only at
// `layer`, random only at `before`, and moves `state` on.
double start_offset(Interlace scheme, std::uint32_t layer, double before, std::uint64_t& state);

} // namespace filum::link3d
