// The planar chain's messages to domain data and back.  All validation of what arrives lives here: sizes that match,
// offsets that ascend, finite numbers, positive widths.  from_* throw Error(bad_input) naming the frame and the fault.
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
