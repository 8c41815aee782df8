// Distributes the options of one command line to the stages that have them.
#pragma once

#include "app/filum/stage.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// The command line of `filum print`.
struct Request {
    std::vector<std::string> inputs; // files of parts, printed together; none: standard input
    std::string output = "-";
    std::string keep;            // folder for the streams of all stages
    std::string picture, report; // names of output files; "": none
    bool dry_run = false;        // print the pipeline instead of running it
    bool quiet = false;
    bool vase = false;                               // --vase: one bead in a helix above a floor
    std::string swapped;                             // the last NAME=FILE of --stage
    std::vector<std::vector<std::string>> arguments; // for each stage, without input and output

    // Whether a picture or a report is made of the toolpath.
    [[nodiscard]] bool shows() const { return !picture.empty() || !report.empty(); }
};

// The value of the option words[i], which is the next word; `i` becomes the index of that word.  Throws Error(usage) if
// there is no next word or it is an option itself.
const std::string& value_behind(const std::vector<std::string>& words, std::size_t& i);

// Gives every option to each stage that has it: one --bead-width serves all stages.  --fill.bead-width goes to `fill`
// alone and wins there.  An option for all stages is not given to a stage where it has no effect, if it has an effect
// in another stage. Some options set others, unless those are given: --vase sets --lift, --nozzle sets --bead-width,
// --wells and --grid set
// --place, --wells sets --wall-height, --body sets --volume, --bath sets --clearance.  --machine sets --head in each
// stage that has --head. A value follows its option after a space or a '='.  All words behind "--" are files. Throws
// Error(usage) for an option that no stage has, and for a missing value.
Request distribute(const std::vector<std::string>& words, const std::vector<Stage>& stages);

} // namespace filum::app::filum
