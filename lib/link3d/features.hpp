// Beads parted by what they are of the part.
#pragma once

#include "link3d/segment_index.hpp"
#include "toolpath/path.hpp"

#include <functional>
#include <span>

namespace filum::link3d {

// Emits `bead` in pieces, each of one feature: that of the segment of `curves` nearest to the middle of each of its
// segments.  In one piece, without a feature, if the curves have none.  `index` is that of `curves`.
void emit_by_feature(toolpath::Span bead, std::span<const toolpath::Curve> curves, const SegmentIndex& index,
                     const std::function<void(const toolpath::Span&)>& emit);

} // namespace filum::link3d
