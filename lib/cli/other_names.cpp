#include "cli/other_names.hpp"

#include <algorithm>
#include <utility>

namespace filum::cli {

namespace {

// Theirs, or ours of before, with '-'; ours: an option, and what to give it where that is a key of the profile.
struct Name {
    std::string_view theirs, option, value;
};
constexpr Name kOtherNames[] = {
    {"least-radius", "min-radius", ""},
    {"least-spacing", "min-spacing", ""},
    {"least-area", "min-area", ""},
    {"height", "layer-height", ""},
    {"line-width", "bead-width", ""},
    {"extrusion-width", "bead-width", ""},
    {"nozzle-diameter", "bead-width", ""},
    {"machine-nozzle-size", "bead-width", ""},
    {"initial-layer-height", "first-layer-height", ""},
    {"layer-height-0", "first-layer-height", ""},
    {"initial-layer-print-height", "first-layer-height", ""},
    {"fill-pattern", "pattern", ""},
    {"infill-pattern", "pattern", ""},
    {"sparse-infill-pattern", "pattern", ""},
    {"fill-density", "infill", ""},
    {"infill-density", "infill", ""},
    {"infill-sparse-density", "infill", ""},
    {"sparse-infill-density", "infill", ""},
    {"perimeters", "walls", ""},
    {"wall-count", "walls", ""},
    {"wall-line-count", "walls", ""},
    {"wall-loops", "walls", ""},
    {"top-solid-layers", "top", ""},
    {"top-layers", "top", ""},
    {"top-shell-layers", "top", ""},
    {"bottom-solid-layers", "bottom", ""},
    {"bottom-layers", "bottom", ""},
    {"bottom-shell-layers", "bottom", ""},
    {"support-material", "support", ""},
    {"support-enable", "support", ""},
    {"enable-support", "support", ""},
    {"fill-angle", "angles", ""},
    {"infill-angles", "angles", ""},
    {"adaptive-layer-height-enabled", "adaptive", ""},
    {"printer", "machine", ""},
    {"printer-profile", "machine", ""},
    {"profile", "machine", ""},
    {"gcode-flavor", "machine", ""},
    {"machine-gcode-flavor", "machine", ""},
    {"export-gcode", "output", ""},
    {"load", "machine", ""},
    {"temperature", "set", "nozzle_temp=210"},
    {"nozzle-temperature", "set", "nozzle_temp=210"},
    {"material-print-temperature", "set", "nozzle_temp=210"},
    {"bed-temperature", "set", "bed_temp=60"},
    {"material-bed-temperature", "set", "bed_temp=60"},
    {"filament-diameter", "set", "extrusion.diameter=1.75"},
    {"material-diameter", "set", "extrusion.diameter=1.75"},
    {"extrusion-multiplier", "set", "extrusion.flow=1"},
    {"material-flow", "set", "extrusion.flow=1"},
    {"print-speed", "set", "feeds.bead=50"},
    {"speed-print", "set", "feeds.bead=50"},
    {"infill-speed", "set", "feeds.bead=50"},
    {"perimeter-speed", "set", "feeds.bead=50"},
    {"first-layer-speed", "set", "feeds.first_layer=25"},
    {"speed-layer-0", "set", "feeds.first_layer=25"},
    {"travel-speed", "set", "feeds.travel=150"},
    {"speed-travel", "set", "feeds.travel=150"},
    {"retract-length", "set", "travel.retract=0.8"},
    {"retraction-amount", "set", "travel.retract=0.8"},
    {"retraction-length", "set", "travel.retract=0.8"},
    {"retract-speed", "set", "travel.retract_speed=35"},
    {"retract-lift", "set", "travel.lift=0.6"},
    {"retraction-hop", "set", "travel.lift=0.6"},
    {"start-gcode", "machine", "FILE, a profile whose templates.start it is"},
    {"end-gcode", "machine", "FILE, a profile whose templates.end it is"},
};

} // namespace

std::string in_our_words(std::string_view name, std::span<const std::string> names) {
    std::string theirs(name.substr(0, name.find('=')));
    std::replace(theirs.begin(), theirs.end(), '_', '-');
    const auto has = [&](std::string_view option) {
        return std::find(names.begin(), names.end(), option) != names.end();
    };
    if (theirs != name && has(theirs)) return "; here it is '--" + theirs + "'";
    for (const Name& n : kOtherNames)
        if (n.theirs == theirs && has(n.option))
            return "; here it is '--" + std::string(n.option) + (n.value.empty() ? "" : " ") + std::string(n.value) +
                   "'";
    return "";
}

} // namespace filum::cli
