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
    std::vector<double> diameter;       // mm, of filament or bore; none: the profile's
    std::vector<double> nozzle;         // mm; none: the profile's
    std::vector<double> layer_time;     // s, the least of a layer; none: the profile's
    std::vector<double> wall_height;    // mm, of wells or fixtures about the part; none: the profile's travel.above
    std::vector<double> z_offset;       // mm; none: the profile's
    std::string pause_at;               // see machine::parse_pauses
    std::string by_layer;               // see parse_by_layer
    std::string thumbnails;             // "220x124,16x16": sizes of pictures at the program's head, pixels
    std::vector<double> path_tolerance; // mm; none: machine::standard_merging
    std::vector<double> axis_tolerance; // degrees; likewise
};

// A value of the profile's [values] from a layer on.
struct LayerValue {
    std::uint32_t layer = 0;
    std::string name;
    double value = 0;
};

// "50:nozzle_temp=205,120:nozzle_temp=200", by layer.  Throws Error(usage) for anything else, for a name that is none
// of [values], and for one that neither the codes of upper_layers nor of features name: it would change nothing.
std::vector<LayerValue> parse_by_layer(const std::string& text, const machine::Profile& profile);

// The machine, as these options have it.  Throws as load_profile does, and Error(usage) for what a machine has no codes
// for (pauses, an offset or values by layer of robots and rotary axes), a tolerance of axes on a machine that cannot
// lean the tool, or for `flatten` on one that can.
machine::Profile profile_for(const Options& options);

} // namespace filum::postproc
