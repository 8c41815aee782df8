// The whole job of `render`: a stream in, and those that its options name; a picture or a page out.
#pragma once

#include "cli/command.hpp"
#include "render/draw.hpp"

namespace filum::app::render {

// Draws the stream that `io` names as its output's name asks: x.html a report, x.svg, x.vtp, else PNG.  Throws
// Error(usage) for options that have no effect together, or where nothing is left to draw.
void run(const filum::render::Options& options, const cli::Io& io);

} // namespace filum::app::render
