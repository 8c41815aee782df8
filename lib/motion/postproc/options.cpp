#include "postproc/options.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/angle.hpp"
#include "machine/template.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace filum::postproc {

namespace {

[[noreturn]] void unfit(const std::string& option, const std::string& why) {
    throw Error(Exit::usage, "cannot use --" + option + ": " + why);
}

constexpr double kWidestBead = 4; // largest section of a bead / (nozzle diameter)2, as in Klipper

// Checks options that need G-code, three axes, certain templates or certain comments.
void check_fit(const Options& o, const machine::Profile& p) {
    const bool codes = p.format.dialect == machine::Dialect::gcode;
    if (!o.z_offset.empty() && p.axes.active())
        unfit("z-offset", "'" + p.name + "' has rotary axes, on which z is no height; move its work offset");
    if (!o.pause_at.empty() && (!codes || (p.templates.pause.empty() && p.preset == nullptr)))
        unfit("pause-at", "'" + p.name + "' has no templates.pause; add the codes that wait there");
    if (!o.thumbnails.empty() && p.format.comments != machine::CommentStyle::semicolon)
        unfit("thumbnails", "hosts find them in comments behind semicolons, and '" + p.name + "' writes none");
    if (!o.by_layer.empty() && !codes) unfit("by-layer", "'" + p.name + "' is a robot, without codes for layers");
}

} // namespace

std::vector<LayerValue> parse_by_layer(const std::string& text, const machine::Profile& profile) {
    std::vector<LayerValue> out;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        const auto colon = word.find(':'), equal = word.find('=');
        if (colon == std::string::npos || equal == std::string::npos || equal < colon)
            unfit("by-layer", "'" + word + "' is not LAYER:NAME=VALUE, as 50:nozzle_temp=205");
        const double layer = parse_number(word.substr(0, colon), "--by-layer");
        if (layer < 0 || layer != std::floor(layer) || layer > 1e9)
            unfit("by-layer", "'" + word.substr(0, colon) + "' is no layer");
        const std::string name = word.substr(colon + 1, equal - colon - 1), braced = "{" + name + "}";
        if (profile.values.count(name) == 0) unfit("by-layer", "'" + name + "' is none of [values] of the profile");
        if (!machine::words_in_braces(profile.templates.upper_layers).contains(name) &&
            !machine::words_in_braces(profile.templates.layer).contains(name))
            unfit("by-layer", "the codes of the profile's layers do not name " + braced);
        out.push_back({static_cast<std::uint32_t>(layer), name, parse_number(word.substr(equal + 1), "--by-layer")});
    }
    std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.layer < b.layer; });
    return out;
}

namespace {

constexpr double kOverWalls = 2; // mm that travels keep above walls

// The keys of the profile to set: those of --set, then those of other options.
std::string changed_keys(const Options& o) {
    std::string out = o.set;
    const auto put = [&](const std::string& key, double value) {
        out += (out.empty() ? "" : ",") + key + "=" + shortest_text(value);
    };
    if (!o.diameter.empty()) put("extrusion.diameter", o.diameter.front());
    if (!o.nozzle.empty()) {
        put("extrusion.nozzle", o.nozzle.front());
        put("limits.section", kWidestBead * o.nozzle.front() * o.nozzle.front());
    }
    if (!o.layer_time.empty()) put("limits.layer_time", o.layer_time.front());
    if (!o.wall_height.empty()) put("travel.above", o.wall_height.front() + kOverWalls);
    return out;
}

void check_sizes(const Options& o, const machine::Profile& p) {
    const auto feeding = p.extrusion.feeding;
    if (!o.diameter.empty() && feeding != machine::Feeding::filament && feeding != machine::Feeding::plunger)
        unfit("diameter", "'" + p.name + "' does not measure filament or the travel of a plunger");
    if (p.travel.above > 0 && p.axes.active())
        unfit("wall-height", "'" + p.name + "' has rotary axes; plan its travels with 'route'");
    if (p.travel.above > p.bed.z_max)
        unfit("wall-height", "travels would be at " + shortest_text(p.travel.above) + " mm, and '" + p.name +
                                 "' reaches up to " + shortest_text(p.bed.z_max) + " mm");
}

} // namespace

machine::Profile profile_for(const Options& o) {
    auto out = machine::load_profile(o.machine, changed_keys(o));
    check_fit(o, out);
    check_sizes(o, out);
    if (!o.z_offset.empty()) out.bed.z_offset = o.z_offset.front();
    out.fibre.omit_short = o.short_strokes == ShortMoves::drop;
    auto merging = machine::standard_merging();
    if (!o.path_tolerance.empty()) merging.planar = merging.surface = o.path_tolerance.front();
    if (!o.axis_tolerance.empty()) merging.axis = geom::radians(o.axis_tolerance.front());
    machine::merge_moves(out, merging);
    if (o.flatten && out.axes.active())
        throw Error(Exit::usage, "--flatten is for machines that hold the nozzle upright: '" + out.name +
                                     "' leans it; leave it out, or name another machine");
    if (!o.axis_tolerance.empty() && !out.axes.active())
        throw Error(Exit::usage, "--axis-tolerance is for machines with rotary axes: '" + out.name +
                                     "' holds the nozzle upright; leave it out, or name another machine");
    return out;
}

} // namespace filum::postproc
