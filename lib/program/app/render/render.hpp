// The whole job of `render`: reads a stream, and those that the options name, and draws a picture or a page.
#pragma once

#include "cli/command.hpp"
#include "render/draw.hpp"

namespace filum::app::render {

// Draws the stream that `io` names.  The ending of the output's name gives the format: .html (report), .svg, .vtp, else
// PNG.  Throws Error(usage) for options that have no effect together, and if nothing is left to draw.
void run(const filum::render::Options& options, const cli::Io& io);

} // namespace filum::app::render
