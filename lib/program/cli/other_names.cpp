#include "cli/other_names.hpp"

#include <algorithm>

namespace filum::cli {

namespace {

// If a name has several entries, the first one counts whose option the program has.
constexpr OtherName kOtherNames[] = {
    // former names of Filum's own options
    {"least-radius", "min-radius"},
    {"least-spacing", "min-spacing"},
    {"least-area", "min-area"},
    {"height", "layer-height"},
    // layers and beads
    {"nozzle-diameter", "bead-width", Value::length},
    {"nozzle-size", "bead-width", Value::length},
    {"nozzle-width", "bead-width", Value::length},
    {"strand-width", "bead-width", Value::length},
    {"strand-diameter", "bead-width", Value::length},
    {"bead", "bead-width", Value::length},
    {"machine-nozzle-size", "bead-width", Value::length},
    {"extrusion-width", "bead-width", Value::length},
    {"line-width", "bead-width", Value::length},
    {"first-layer-height", "first-layer-height", Value::length},
    {"initial-layer-height", "first-layer-height", Value::length},
    {"initial-layer-print-height", "first-layer-height", Value::length},
    {"layer-height-0", "first-layer-height", Value::length},
    {"adaptive-layer-height-enabled", "adaptive", Value::flag},
    {"duplicate", "copies"},
    {"duplicate-distance", "apart", Value::length},
    {"cut", "cut-below", Value::none},
    {"xy-size-compensation", "xy-compensation"},
    {"xy-contour-compensation", "xy-compensation"},
    {"xy-offset", "xy-compensation"},
    {"horizontal-expansion", "xy-compensation"},
    {"xy-hole-compensation", "hole-compensation"},
    {"hole-xy-offset", "hole-compensation"},
    {"elefant-foot-compensation", "elephant-foot", Value::length},
    {"elephant-foot-compensation", "elephant-foot", Value::length},
    {"filament-shrink", "shrinkage", Value::shrinks_to},
    {"filament-shrinkage-compensation-xy", "shrinkage", Value::shrinks_by},
    {"filament-shrinkage-compensation-z", "shrinkage", Value::shrinks_z},
    {"seam-position", "seam", Value::seam},
    {"z-seam-type", "seam", Value::none},
    {"pause-at-layer", "pause-at"},
    {"rotate-x", "rotate", Value::turn_x},
    {"rotate-y", "rotate", Value::turn_y},
    {"rotate-z", "rotate", Value::turn_z},
    // infill
    {"perimeters", "walls"},
    {"wall-count", "walls"},
    {"wall-line-count", "walls"},
    {"wall-loops", "walls"},
    {"fill-density", "infill", Value::share},
    {"infill-density", "infill", Value::share},
    {"infill-sparse-density", "infill", Value::share},
    {"sparse-infill-density", "infill", Value::share},
    {"fill-pattern", "infill-pattern", Value::pattern},
    {"sparse-infill-pattern", "infill-pattern", Value::pattern},
    {"fill-pattern", "pattern", Value::none},
    {"infill-pattern", "pattern", Value::none},
    {"sparse-infill-pattern", "pattern", Value::none},
    {"fill-angle", "angles", Value::none},
    {"infill-angles", "angles", Value::none},
    {"top-solid-layers", "top"},
    {"top-layers", "top"},
    {"top-shell-layers", "top"},
    {"bottom-solid-layers", "bottom"},
    {"bottom-layers", "bottom"},
    {"bottom-shell-layers", "bottom"},
    {"solid-infill-below-area", "solid-below"},
    // supports, raft, brim and skirt
    {"support-material", "support", Value::flag},
    {"support-enable", "support", Value::flag},
    {"enable-support", "support", Value::flag},
    {"support-material-threshold", "support-angle", Value::steepness},
    {"support-material-buildplate-only", "support-on", Value::bed_only},
    {"support-material-xy-spacing", "beside", Value::length},
    {"support-material-spacing", "support-spacing", Value::length},
    {"support-material-interface-layers", "interface"},
    {"raft-layers", "raft"},
    {"brim-width", "brim"},
    {"skirt-distance", "skirt"},
    // the machine
    {"printer", "machine", Value::none},
    {"printer-profile", "machine", Value::none},
    {"profile", "machine", Value::none},
    {"load", "machine", Value::none},
    {"gcode-flavor", "machine", Value::none},
    {"machine-gcode-flavor", "machine", Value::none},
    {"bed", "bed", Value::bed},
    {"bed-size", "bed", Value::bed},
    {"bed-shape", "bed", Value::bed},
    {"printable-area", "bed", Value::bed},
    {"fan", "fan", Value::fan},
    {"fan-speed", "fan", Value::fan},
    {"cooling-fan-speed", "fan", Value::fan},
    {"start-gcode", "templates.start", Value::text},
    {"end-gcode", "templates.end", Value::text},
    {"export-gcode", "output", Value::none},
    {"filament-diameter", "extrusion.diameter", Value::key},
    {"material-diameter", "extrusion.diameter", Value::key},
    {"extrusion-multiplier", "extrusion.flow", Value::key},
    {"temperature", "nozzle_temp", Value::key},
    {"nozzle-temperature", "nozzle_temp", Value::key},
    {"material-print-temperature", "nozzle_temp", Value::key},
    {"first-layer-temperature", "first_nozzle_temp", Value::key},
    {"bed-temperature", "bed_temp", Value::key},
    {"material-bed-temperature", "bed_temp", Value::key},
    {"first-layer-bed-temperature", "first_bed_temp", Value::key},
    {"print-speed", "feeds.bead", Value::key},
    {"speed-print", "feeds.bead", Value::key},
    {"perimeter-speed", "feeds.wall", Value::key},
    {"external-perimeter-speed", "feeds.outer_wall", Value::key},
    {"infill-speed", "feeds.infill", Value::key},
    {"solid-infill-speed", "feeds.solid", Value::key},
    {"top-solid-infill-speed", "feeds.top", Value::key},
    {"support-material-speed", "feeds.support", Value::key},
    {"support-material-interface-speed", "feeds.interface", Value::key},
    {"first-layer-speed", "feeds.first_layer", Value::key},
    {"speed-layer-0", "feeds.first_layer", Value::key},
    {"travel-speed", "feeds.travel", Value::key},
    {"speed-travel", "feeds.travel", Value::key},
    {"retract-length", "travel.retract", Value::key},
    {"retraction-amount", "travel.retract", Value::key},
    {"retraction-length", "travel.retract", Value::key},
    {"retract-speed", "travel.retract_speed", Value::key},
    {"retract-lift", "travel.lift", Value::key},
    {"retraction-hop", "travel.lift", Value::key},
};

} // namespace

namespace {

// Whether the entry stands for keys of the machine's profile.
bool sets_key(Value value) {
    return value == Value::key || value == Value::text || value == Value::bed || value == Value::fan;
}

} // namespace

const OtherName* other_name(std::string_view theirs, const std::function<bool(std::string_view)>& has) {
    std::string name(theirs.substr(0, theirs.find('=')));
    std::replace(name.begin(), name.end(), '_', '-');
    const auto* at = std::find_if(std::begin(kOtherNames), std::end(kOtherNames), [&](const OtherName& n) {
        return n.theirs == name && has(sets_key(n.value) ? "set" : n.ours);
    });
    return at == std::end(kOtherNames) ? nullptr : at;
}

std::string ours_of(const OtherName& name) {
    if (name.value == Value::key) return "--set " + std::string(name.ours) + "=N";
    if (name.value == Value::text) return "--set " + std::string(name.ours) + "=CODE";
    if (name.value == Value::bed) return "--set bed.x=[0,W],bed.y=[0,D]";
    if (name.value == Value::fan) return "--set fan=N";
    return "--" + std::string(name.ours);
}

std::string in_our_words(std::string_view theirs, std::span<const std::string> names) {
    const auto has = [&](std::string_view option) {
        return std::find(names.begin(), names.end(), option) != names.end();
    };
    std::string dashed(theirs.substr(0, theirs.find('=')));
    std::replace(dashed.begin(), dashed.end(), '_', '-');
    if (dashed != theirs && has(dashed)) return "; here it is '--" + dashed + "'";
    const OtherName* known = other_name(theirs, has);
    return known != nullptr ? "; here it is '" + ours_of(*known) + "'" : "";
}

std::string as_command(std::string_view program, std::string_view option) {
    struct OwnCommand {
        std::string_view program, option, command;
    };
    constexpr OwnCommand kOwnCommands[] = {{"surfpath", "compare", "filum compare FACE -o FOLDER"},
                                           {"choose", "compare", "filum compare FACE -o FOLDER"}};
    for (const OwnCommand& c : kOwnCommands)
        if (c.program == program && c.option == option)
            return "; the command '" + std::string(c.command) + "' does that";
    return "";
}

} // namespace filum::cli
