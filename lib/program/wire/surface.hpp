// Converts the messages of surface stages to domain data and back, and validates all data from a stream.
#pragma once

#include "stream/frame.hpp"
#include "surface/sheet.hpp"

namespace filum::wire {

// Throws Error(bad_input) naming the frame and the fault.
surface::Sheet sheet(const stream::RawFrame& frame);

// Throws Error(failure) if the surface is too large for a frame: beyond about two million triangles.
stream::RawFrame frame(const surface::Sheet& sheet);

} // namespace filum::wire
