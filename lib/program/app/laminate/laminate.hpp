// The whole job of `laminate`: reads surfaces and a list of plies, and writes a toolpath and a map.
#pragma once

#include "cli/command.hpp"
#include "laminate/laminate.hpp"

namespace filum::app::laminate {

struct Options {
    std::string plies = "0,45,-45,90", table, reference = "X", ramp; // as the user types them
    std::string map, trim_list;                                      // names of output files
    std::string machine; // profile that must allow turns outside the part; "": not checked
    bool symmetric = false;
    filum::laminate::Ply like; // default values, for what plies and table leave open
    std::int64_t tool = 0;
    filum::laminate::Options how;
};

// The slope of a ramp: 20 for "1:20", 0 for "".  Throws Error(usage) for other text.
double ramp(const std::string& words);

// The area of a ply by a word of the table: "faces:3,4", or the name of a file of curves.  Throws Error: usage for
// faces that are no numbers, io and bad_input for the file.
filum::laminate::Area within(const std::string& word);

// Reads surfaces, plans the plies on each, and writes one toolpath.  With `map` it also writes the surfaces of the map
// to that file.  Throws Error as laminate() and the parsers of plies.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::laminate
