#include "app/filum/slicer_names.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>

namespace filum::app::filum {

namespace {

// How a value of theirs becomes one of ours.
enum class As : std::uint8_t {
    same,      // as it stands
    length,    // mm; a share of something else is left, and so is 0, which says "by itself"
    share,     // 15% or 15 becomes 15%
    flag,      // 0 or 1
    steepness, // degrees from the horizontal; here they count from the vertical
    pattern,   // of infill
    key,       // of the machine's profile, by --set; a share of something else is left
    bed_only,  // 0 or 1: where supports may stand
    turn_x,    // degrees
    turn_y,
    turn_z,
};

struct Name {
    std::string_view theirs, ours;
    As as = As::same;
};

constexpr Name kNames[] = {
    {"nozzle", "bead-width"},
    {"nozzle-diameter", "bead-width", As::length},
    {"extrusion-width", "bead-width", As::length},
    {"line-width", "bead-width", As::length},
    {"first-layer-height", "first-layer-height", As::length},
    {"perimeters", "walls"},
    {"wall-loops", "walls"},
    {"wall-line-count", "walls"},
    {"fill-density", "infill", As::share},
    {"infill-density", "infill", As::share},
    {"sparse-infill-density", "infill", As::share},
    {"infill-sparse-density", "infill", As::share},
    {"fill-pattern", "infill-pattern", As::pattern},
    {"sparse-infill-pattern", "infill-pattern", As::pattern},
    {"top-solid-layers", "top"},
    {"top-layers", "top"},
    {"top-shell-layers", "top"},
    {"bottom-solid-layers", "bottom"},
    {"bottom-layers", "bottom"},
    {"bottom-shell-layers", "bottom"},
    {"solid-infill-below-area", "solid-below"},
    {"support-material", "support", As::flag},
    {"enable-support", "support", As::flag},
    {"support-enable", "support", As::flag},
    {"support-material-threshold", "support-angle", As::steepness},
    {"support-material-buildplate-only", "support-on", As::bed_only},
    {"support-material-xy-spacing", "beside", As::length},
    {"support-material-spacing", "support-spacing", As::length},
    {"support-material-interface-layers", "interface"},
    {"brim-width", "brim"},
    {"skirt-distance", "skirt"},
    {"filament-diameter", "extrusion.diameter", As::key},
    {"extrusion-multiplier", "extrusion.flow", As::key},
    {"temperature", "nozzle_temp", As::key},
    {"nozzle-temperature", "nozzle_temp", As::key},
    {"first-layer-temperature", "first_nozzle_temp", As::key},
    {"bed-temperature", "bed_temp", As::key},
    {"first-layer-bed-temperature", "first_bed_temp", As::key},
    {"print-speed", "feeds.bead", As::key},
    {"perimeter-speed", "feeds.wall", As::key},
    {"external-perimeter-speed", "feeds.outer_wall", As::key},
    {"infill-speed", "feeds.infill", As::key},
    {"solid-infill-speed", "feeds.solid", As::key},
    {"top-solid-infill-speed", "feeds.top", As::key},
    {"support-material-speed", "feeds.support", As::key},
    {"support-material-interface-speed", "feeds.interface", As::key},
    {"first-layer-speed", "feeds.first_layer", As::key},
    {"travel-speed", "feeds.travel", As::key},
    {"retract-length", "travel.retract", As::key},
    {"retract-speed", "travel.retract_speed", As::key},
    {"retract-lift", "travel.lift", As::key},
    {"rotate-x", "rotate", As::turn_x},
    {"rotate-y", "rotate", As::turn_y},
    {"rotate-z", "rotate", As::turn_z},
};

// Ours by the same name and with the same meaning in a file.
constexpr std::string_view kSame[] = {"layer-height"};

std::string dashed(std::string name) {
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

std::string trimmed(const std::string& text) {
    const auto from = text.find_first_not_of(" \t\r");
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

const Name* known(const std::string& dashed_name) {
    const auto* at =
        std::find_if(std::begin(kNames), std::end(kNames), [&](const Name& n) { return n.theirs == dashed_name; });
    return at == std::end(kNames) ? nullptr : at;
}

bool percent(const std::string& text) { return !text.empty() && text.back() == '%'; }

double number(const std::string& text, const std::string& of) {
    return parse_number(percent(text) ? text.substr(0, text.size() - 1) : text, "--" + of);
}

// Slicers' patterns of straight lines that this program lays as rows, and of waves.
std::string pattern(const std::string& theirs) {
    for (const char* rows : {"rectilinear", "alignedrectilinear", "line", "lines", "grid", "zigzag", "zig-zag", "rows"})
        if (theirs == rows) return "rows";
    return theirs == "gyroid" || theirs == "wave" ? "wave" : "";
}

// Our words for a setting; none if it says what has no meaning here.
std::optional<std::string> translated(const Name& n, const std::string& value) {
    const std::string option = "--" + std::string(n.ours), theirs(n.theirs);
    switch (n.as) {
    case As::same:
        return option + "=" + value;
    case As::length:
        if (percent(value) || number(value, theirs) <= 0) return std::nullopt;
        return option + "=" + value;
    case As::share:
        return option + "=" + (percent(value) ? value : shortest_text(number(value, theirs)) + "%");
    case As::flag:
        if (!value.empty() && value != "1") return std::nullopt;
        return option;
    case As::steepness:
        if (number(value, theirs) <= 0) return std::nullopt;
        return option + "=" + shortest_text(90 - number(value, theirs));
    case As::pattern:
        if (pattern(value).empty()) return std::nullopt;
        return option + "=" + pattern(value);
    case As::key:
        if (percent(value)) return std::nullopt;
        number(value, theirs);
        return "--set=" + std::string(n.ours) + "=" + value;
    case As::bed_only:
        if (value != "1") return std::nullopt;
        return option + "=bed";
    case As::turn_x:
        return option + "=" + value + ",0,0";
    case As::turn_y:
        return option + "=0," + value + ",0";
    case As::turn_z:
        return option + "=0,0," + value;
    }
    return std::nullopt;
}

bool has(const std::vector<Stage>& stages, const std::string& name) {
    return std::any_of(stages.begin(), stages.end(), [&](const Stage& s) {
        return std::any_of(s.options.begin(), s.options.end(), [&](const StageOption& o) { return o.name == name; });
    });
}

struct Setting {
    std::string key, value;
};

std::vector<Setting> settings_in(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw Error(Exit::io, "cannot read '" + file + "': " + std::strerror(errno));
    std::vector<Setting> out;
    for (std::string line; std::getline(in, line);) {
        line = trimmed(line);
        const auto equal = line.find('=');
        if (line.empty() || line[0] == '#' || line[0] == ';' || line[0] == '[' || equal == std::string::npos) continue;
        out.push_back({trimmed(line.substr(0, equal)), trimmed(line.substr(equal + 1))});
    }
    if (out.empty())
        throw Error(Exit::bad_input, "cannot use '" + file +
                                         "': it has no line 'name = value'; export the settings of "
                                         "the slicer as an .ini file");
    return out;
}

bool says_nothing(const std::string& value) {
    return value.empty() || value == "0" || value == "0%" || value == "\"\"";
}

// What of a file has a meaning here.  Lists, as for several extruders, give their first value.
void load(const std::string& file, Translated& out) {
    const std::vector<Setting> all = settings_in(file);
    const auto value_of = [&](std::string_view key) {
        for (const Setting& s : all)
            if (dashed(s.key) == key) return s.value;
        return std::string();
    };
    const bool supports = value_of("support-material") == "1", wide = !says_nothing(value_of("extrusion-width"));
    for (const Setting& s : all) {
        const std::string name = dashed(s.key), value = s.value.substr(0, s.value.find_first_of(",;"));
        const Name* n = known(name);
        const bool of_supports = name.starts_with("support-material-");
        // a skirt of none is none at any distance; the nozzle is as wide as the bead where that is not said
        const bool idle = (of_supports && !supports) ||
                          (name == "skirt-distance" && says_nothing(value_of("skirts"))) ||
                          (name == "nozzle-diameter" && wide) || name == "skirts" || says_nothing(value);
        std::optional<std::string> word;
        try {
            if (n != nullptr && !idle) word = translated(*n, value);
        } catch (const Error&) { // a value of another kind
        }
        if (std::find(std::begin(kSame), std::end(kSame), name) != std::end(kSame)) word = "--" + name + "=" + value;
        if (word)
            out.words.push_back(*word);
        else if (!idle)
            out.left.push_back(s.key);
    }
}

// --rotate 45, --scale 150%: our options, values of theirs.
std::string own_value(const std::string& name, const std::string& value) {
    if (name == "rotate" && value.find(',') == std::string::npos && !value.empty()) return "0,0," + value;
    if (name == "scale" && percent(value)) return shortest_text(number(value, name) / 100);
    return value;
}

// All --set as one, where the first of them was.
void join_sets(std::vector<std::string>& words) {
    const std::string set = "--set=";
    std::string all;
    std::size_t first = words.size();
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--") break;
        if (!words[i].starts_with(set)) continue;
        first = std::min(first, i);
        all += (all.empty() ? "" : ",") + words[i].substr(set.size());
    }
    if (first == words.size()) return;
    words[first] = set + all;
    const auto rest = words.begin() + static_cast<std::ptrdiff_t>(first) + 1;
    const auto end = std::find(rest, words.end(), "--");
    words.erase(std::remove_if(rest, end, [&](const std::string& w) { return w.starts_with(set); }), end);
}

} // namespace

Translated in_our_words(const std::vector<std::string>& words, const std::vector<Stage>& stages) {
    Translated out;
    std::vector<std::string> rest;
    std::size_t i = 0;
    for (; i < words.size() && words[i] != "--"; ++i) {
        const std::string& word = words[i];
        const auto equal = word.find('=');
        const std::string typed =
            word.starts_with("--") ? word.substr(2, equal == std::string::npos ? equal : equal - 2) : "";
        const auto value = [&]() -> std::string {
            if (equal != std::string::npos) return word.substr(equal + 1);
            if (i + 1 == words.size())
                throw Error(Exit::usage, "cannot use '--" + typed + "' without a value; see 'filum help print'");
            return words[++i];
        };
        const Name* n = typed.empty() || has(stages, typed) ? nullptr : known(dashed(typed));
        if (typed == "load") {
            load(value(), out);
        } else if (typed == "set" || typed == "rotate" || typed == "scale") {
            rest.push_back("--" + typed + "=" + own_value(typed, value()));
        } else if (n != nullptr) {
            const std::string given = n->as == As::flag && equal == std::string::npos ? "1" : value();
            const auto ours = translated(*n, given);
            if (!ours)
                throw Error(Exit::usage, "cannot use '--" + typed + "' with '" + given + "'; here it is '" +
                                             (n->as == As::key ? "--set " : "--") + std::string(n->ours) + "'");
            rest.push_back(*ours);
        } else {
            rest.push_back(word);
        }
    }
    out.words.insert(out.words.end(), rest.begin(), rest.end());
    out.words.insert(out.words.end(), words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
    join_sets(out.words);
    return out;
}

} // namespace filum::app::filum
