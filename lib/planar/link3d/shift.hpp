// Lanes to the start of the next layer that the scheme of interlacing asks for (interlace.hpp).
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// Whether the front region's last bead, including the overlap of a ramp, ends at least kApart bead widths from the
// layer's start.
bool apart(const State& state, const Bead& bead);

// A lane from the end of the front region's last bead to the start that the scheme asks for on the next layer. If no
// lane leads there, it ends as near as possible. The next start is always at least kApart bead widths from this layer's
// start. Nothing if there is no such lane. Moves the column to its next offset.
std::optional<std::vector<Vec2>> shift(State& state, std::uint32_t c, const Bead& bead);

} // namespace filum::link3d
