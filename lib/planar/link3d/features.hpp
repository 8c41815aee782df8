// Splits beads by feature (wall, infill, ...).
#pragma once

#include "link3d/segment_index.hpp"
#include "toolpath/path.hpp"

#include <functional>
#include <span>

namespace filum::link3d {

// Emits `bead` in pieces of one feature and one share over air each. A segment takes those of the segment of `curves`
// nearest to its middle; `index` holds `curves`. If the curves have no features, the bead is emitted as it is.
void emit_by_feature(toolpath::Span bead, std::span<const toolpath::Curve> curves, const SegmentIndex& index,
                     const std::function<void(const toolpath::Span&)>& emit);

} // namespace filum::link3d
