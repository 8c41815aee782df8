// What the user of `postproc` says.
#pragma once

#include "machine/profile.hpp"

#include <string>
#include <vector>

namespace filum::postproc {

enum class Place : std::uint8_t {
    center, // the middle of the visited box goes to the middle of the bed
    as_is,  // coordinates stay
};

enum class Short : std::uint8_t { error, drop };

struct Options {
    std::string machine = "marlin"; // profile: name or file
    Place place = Place::center;
    std::string orient = "as-is";       // see parse_orient
    std::string set;                    // "key=value,..."
    Short short_strokes = Short::error; // of fibre, below its least path
    std::string job;                    // file
    std::string summary;                // file
    std::string modules;                // folder
    bool flatten = false;               // an upright nozzle may follow a path that leans the tool
    std::vector<double> path_tolerance; // mm; none: machine::standard_merging
    std::vector<double> axis_tolerance; // degrees; likewise
};

// The machine, as these options have it.  Throws as load_profile does, and Error(usage) for a tolerance of axes on a
// machine that cannot lean the tool, or for `flatten` on one that can.
machine::Profile profile_for(const Options& options);

} // namespace filum::postproc
