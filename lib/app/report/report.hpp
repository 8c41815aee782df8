// The whole job of `render -o x.html`: streams in, one page out.
#pragma once

#include "cli/command.hpp"

#include <string>

namespace filum::app::report {

struct Options {
    std::string machine = "marlin"; // profile of the speeds
    std::string regions, surface;   // files of streams: outlines, what the toolpath lies on
    std::string beside;             // file of a stream that is shown beside
    std::string figures;            // file of figures, TSV
    std::string collisions;         // file of `collide --places`
    std::string title;              // what the page is called; "": the name of the file
};

// Reads the stream that `io` names, and those of the options, and writes the page.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::report
