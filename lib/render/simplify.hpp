// Leaves out points of paths that pictures do not need.
#pragma once

#include "toolpath/path.hpp"

#include <cstdint>
#include <vector>

namespace filum::render {

// Indices of the points to keep. A point that is left out lies within `tolerance` mm of the line between the kept
// points around it, and its width differs by at most that much from the one interpolated there. Greedy; at most 24
// points lie between two kept ones.
std::vector<std::uint32_t> visible_points(const toolpath::Span& s, double tolerance);

} // namespace filum::render
