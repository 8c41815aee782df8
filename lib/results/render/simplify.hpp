// Leaves out points of paths that pictures do not need.
#pragma once

#include "toolpath/path.hpp"

#include <cstdint>
#include <vector>

namespace filum::render {

// Indices of the points to keep. A point that is left out lies within `tolerance` mm of the line between the kept
// points around it. Its width differs by at most `tolerance` from the interpolated one. Greedy: each segment is
// extended as far as possible, over at most 24 segments of the path.
std::vector<std::uint32_t> visible_points(const toolpath::Span& s, double tolerance);

} // namespace filum::render
