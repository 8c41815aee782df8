// What the user of `postproc` says.
#pragma once

#include "machine/profile.hpp"

#include <string>
#include <vector>

namespace filum::postproc {

struct Options {
    std::string machine = "marlin";      // profile: name or file
    std::string place = "center";        // center | as-is
    std::string orient = "as-is";        // see parse_orient
    std::string set;                     // "key=value,..."
    std::string short_strokes = "error"; // of fibre, below its least path: error | drop
    std::string job;                     // file
    std::string summary;                 // file
    std::string modules;                 // folder
    bool flatten = false;                // an upright nozzle may follow a path that leans the tool
    std::vector<double> path_tolerance;  // mm; none: machine::standard_merging
    std::vector<double> axis_tolerance;  // degrees; likewise
};

// The machine, as these options have it.  Throws as load_profile does, and Error(usage) for a tolerance of axes on a
// machine that cannot lean the tool, or for `flatten` on one that can.
machine::Profile profile_for(const Options& options);

} // namespace filum::postproc
