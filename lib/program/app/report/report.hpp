// The whole job of `render -o x.html`: reads streams and writes one page.
#pragma once

#include "cli/command.hpp"

#include <string>

namespace filum::app::report {

struct Options {
    std::string machine = "marlin"; // profile that gives the speeds
    std::string regions, surface;   // files of streams: the outlines, the surface below the toolpath; "": none
    std::string beside;             // file of a stream that is shown beside the first; "": none
    std::string figures;            // file of figures (TSV); "": none
    std::string collisions;         // file of `collide --places`; "": none
    std::string title;              // title of the page; "": the name of the file
};

// Reads the stream that `io` names and those of the options, and writes the page.  Throws Error.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::report
