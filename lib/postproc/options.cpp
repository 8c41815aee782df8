#include "postproc/options.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace filum::postproc {

namespace {

[[noreturn]] void unfit(const std::string& option, const std::string& why) {
    throw Error(Exit::usage, "cannot use --" + option + ": " + why);
}

// What only programs of codes on three axes, or with their templates, can do.
void check_fit(const Options& o, const machine::Profile& p) {
    const bool codes = p.format.dialect == machine::Dialect::gcode;
    if (!o.z_offset.empty() && p.axes.active())
        unfit("z-offset", "'" + p.name + "' has rotary axes, on which z is no height; move its work offset");
    if (!o.pause_at.empty() && (!codes || p.templates.pause.empty()))
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
        if (profile.templates.upper_layers.find(braced) == std::string::npos &&
            profile.templates.layer.find(braced) == std::string::npos)
            unfit("by-layer", "the codes of the profile's layers do not name " + braced);
        out.push_back({static_cast<std::uint32_t>(layer), name, parse_number(word.substr(equal + 1), "--by-layer")});
    }
    std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.layer < b.layer; });
    return out;
}

machine::Profile profile_for(const Options& o) {
    auto out = machine::load_profile(o.machine, o.set);
    check_fit(o, out);
    if (!o.z_offset.empty()) out.bed.z_offset = o.z_offset.front();
    out.fibre.omit_short = o.short_strokes == Short::drop;
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
