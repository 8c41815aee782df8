// Fewer points for paths whose pictures do not need all of them.
#pragma once

#include "toolpath/path.hpp"

#include <cstdint>
#include <vector>

namespace filum::render {

// Indices of the points that a picture needs: those left out lie within `tolerance` mm of the line between those kept
// around them, and so do the widths there.  Greedy; long stretches are cut after 24 points.
std::vector<std::uint32_t> visible_points(const toolpath::Span& s, double tolerance);

} // namespace filum::render
