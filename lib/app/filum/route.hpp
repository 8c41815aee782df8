// One command line for many stages: which option is whose.
#pragma once

#include "app/filum/stage.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// What `filum print` was asked to do.
struct Request {
    std::vector<std::string> inputs; // several are made together; none: standard input
    std::string output = "-";
    std::string keep;            // folder for the streams of all stages
    std::string picture, report; // files
    bool dry_run = false;        // show the pipeline only
    bool quiet = false;
    bool vase = false;                               // one bead in a helix above a floor
    std::string swapped;                             // the last NAME=FILE of --stage
    std::vector<std::vector<std::string>> arguments; // for each stage, without input and output

    [[nodiscard]] bool shows() const {
        return !picture.empty() || !report.empty();
    } // something is made of the toolpath
};

// The value of the option words[i]: the word behind it, to which `i` goes on.  Throws Error(usage) if there is none, or
// if it is an option itself.
const std::string& value_behind(const std::vector<std::string>& words, std::size_t& i);

// Gives every option to each stage that has it, so that one --bead-width serves all; --fill.bead-width goes to `fill`
// alone and wins there.  Where it would do nothing, an option for all is left out, if it does something in another
// stage.
// --vase asks link3d for a helix, --nozzle for beads as wide, --wells for travels above the walls, each unless another
// value is given.  --machine also names the head of each stage that
// has a --head and is not given one.  Options take their value behind a space or a '='; behind "--" all are names.
// Throws Error(usage) for options that no stage has, values that are missing.
Request route(const std::vector<std::string>& words, const std::vector<Stage>& stages);

} // namespace filum::app::filum
