// Lanes to where the scheme of starts wants the next layer to begin (interlace.hpp).
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// Whether the front region's last bead, as a ramp makes it, ends far enough from where the layer began.
bool apart(const State& state, const Bead& bead);

// A lane from the end of the front region's last bead to where the scheme wants the next layer to begin, or as near to
// it as there is a way; at any rate kApart from where this layer began.
std::optional<std::vector<Vec2>> shift(State& state, std::uint32_t c, const Bead& bead);

} // namespace filum::link3d
