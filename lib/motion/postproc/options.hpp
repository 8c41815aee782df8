// The options of `postproc`.
#pragma once

#include "machine/profile.hpp"

#include <string>
#include <vector>

namespace filum::postproc {

enum class Place : std::uint8_t {
    center, // the middle of the visited box moves to the middle of the bed
    as_is,  // coordinates stay
};

enum class ShortMoves : std::uint8_t { error, drop };

struct Options {
    std::string machine = "marlin"; // profile: name or file
    Place place = Place::center;
    std::string orient = "as-is";                 // see parse_orient
    std::string set;                              // "key=value,..."
    ShortMoves short_strokes = ShortMoves::error; // fibre strokes below fibre.least_path
    std::string job;                              // file
    std::string summary;                          // file
    std::string modules;                          // folder
    bool flatten = false;                         // an upright nozzle may follow a path that leans the tool
    std::vector<double> diameter;                 // mm, of filament or bore; none: the profile's
    std::vector<double> nozzle;                   // mm; none: the profile's
    std::vector<double> layer_time;               // s, minimum per layer; none: the profile's
    std::vector<double> wall_height;              // mm, of wells or fixtures around the part; none: travel.above
    std::vector<double> z_offset;                 // mm; none: the profile's
    std::string pause_at;                         // see machine::parse_pauses
    std::string by_layer;                         // see parse_by_layer
    std::string thumbnails;                       // "220x124,16x16": sizes of pictures at the program's head, pixels
    std::vector<double> path_tolerance;           // mm; none: machine::standard_merging
    std::vector<double> axis_tolerance;           // degrees; none: machine::standard_merging
};

// A new value for a name of the profile's [values], from a layer on.
struct LayerValue {
    std::uint32_t layer = 0;
    std::string name;
    double value = 0;
};

// Parses "50:nozzle_temp=205,120:nozzle_temp=200"; the result is sorted by layer.  Throws Error(usage) for any other
// text, and for a name that is not in [values].  It throws, too, for a name that is missing in both
// templates.upper_layers and templates.layer, as it would change nothing.
std::vector<LayerValue> parse_by_layer(const std::string& text, const machine::Profile& profile);

// The machine's profile with these options applied.  Throws as load_profile does.  Throws Error(usage) for an option
// that the machine cannot use.  Pauses, thumbnails and values by layer need codes or comments for them.  A z offset, a
// wall height and `flatten` need three axes; an axis tolerance needs rotary ones.
machine::Profile profile_for(const Options& options);

} // namespace filum::postproc
