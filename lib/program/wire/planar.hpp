// Converts the messages of planar stages to domain data and back. All data from a stream is validated here: sizes
// match, offsets ascend, numbers are finite, widths are positive. The functions that read a frame throw
// Error(bad_input) naming the frame and the fault.
#pragma once

#include "polygon/region.hpp"
#include "stream/frame.hpp"
#include "toolpath/path.hpp"

namespace filum::wire {

polygon::Layer layer(const stream::RawFrame& frame);
polygon::Region region(const stream::RawFrame& frame);
toolpath::RegionPaths paths(const stream::RawFrame& frame);
toolpath::Span span(const stream::RawFrame& frame);

stream::RawFrame frame(const polygon::Layer& layer);
stream::RawFrame frame(const polygon::Region& region);
stream::RawFrame frame(const toolpath::RegionPaths& paths);
stream::RawFrame frame(const toolpath::Span& span);

} // namespace filum::wire
