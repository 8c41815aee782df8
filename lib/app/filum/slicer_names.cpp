#include "app/filum/slicer_names.hpp"

#include "app/filum/slicer_file.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "cli/other_names.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>

namespace filum::app::filum {

namespace {

using cli::OtherName;
using cli::Value;

// Ours by the same name and with the same meaning in a file.
constexpr std::string_view kSame[] = {"layer-height", "z-offset"};

std::string dashed(std::string name) {
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

std::string option_of(const std::string& name, const std::string& value) {
    std::string out = "--";
    out.append(name).append("=").append(value);
    return out;
}

bool percent(const std::string& text) { return !text.empty() && text.back() == '%'; }

double number(const std::string& text, const std::string& of) {
    return parse_number(percent(text) ? text.substr(0, text.size() - 1) : text, "--" + of);
}

// Slicers' patterns of straight lines that this program lays as rows, of waves, and of lines along the outline.
std::string pattern(const std::string& theirs) {
    for (const char* rows : {"rectilinear", "alignedrectilinear", "line", "lines", "grid", "zigzag", "zig-zag", "rows"})
        if (theirs == rows) return "rows";
    if (theirs == "concentric") return "concentric";
    return theirs == "gyroid" || theirs == "wave" ? "wave" : "";
}

// Strokes begin where they are least seen, or where the one before ended: few that they are, nobody lines them up.
std::string seam(const std::string& theirs) {
    if (theirs == "rear" || theirs == "back") return "back";
    return theirs == "nearest" ? "nearest" : "";
}

// The option for a part that loses so many % of its size in x and y, or in z.
std::optional<std::string> shrinkage(const std::string& option, double lost, bool in_z = false) {
    if (!(lost > 0)) return std::nullopt;
    const std::string text = shortest_text(lost);
    return option + (in_z ? "=0,0," + text : "=" + text + "," + text + ",0");
}

// PrusaSlicer says what is lost, at most 10 %; OrcaSlicer what is left, by the same name.
double lost_in_z(double value) { return value > 10 ? 100 - value : value; }

// Our words for a setting; none if it says what has no meaning here.
std::optional<std::string> translated(const OtherName& n, const std::string& value) {
    const std::string option = "--" + std::string(n.ours), theirs(n.theirs);
    switch (n.value) {
    case Value::same:
        return option + "=" + value;
    case Value::length:
        if (percent(value) || number(value, theirs) <= 0) return std::nullopt;
        return option + "=" + value;
    case Value::share:
        return option + "=" + (percent(value) ? value : shortest_text(number(value, theirs)) + "%");
    case Value::flag:
        if (!value.empty() && value != "1") return std::nullopt;
        return option;
    case Value::steepness:
        if (number(value, theirs) <= 0) return std::nullopt;
        return option + "=" + shortest_text(90 - number(value, theirs));
    case Value::pattern:
        if (pattern(value).empty()) return std::nullopt;
        return option + "=" + pattern(value);
    case Value::seam:
        if (seam(value).empty()) return std::nullopt;
        return option + "=" + seam(value);
    case Value::shrinks_by:
        return shrinkage(option, number(value, theirs));
    case Value::shrinks_to:
        return shrinkage(option, 100 - number(value, theirs));
    case Value::shrinks_z:
        return shrinkage(option, lost_in_z(number(value, theirs)), true);
    case Value::key:
        if (percent(value)) return std::nullopt;
        number(value, theirs);
        return "--set=" + std::string(n.ours) + "=" + value;
    case Value::bed_only:
        if (value != "1") return std::nullopt;
        return option + "=bed";
    case Value::turn_x:
        return option + "=" + value + ",0,0";
    case Value::turn_y:
        return option + "=0," + value + ",0";
    case Value::turn_z:
        return option + "=0,0," + value;
    case Value::none:
        break;
    }
    return std::nullopt;
}

bool has(const std::vector<Stage>& stages, std::string_view name) {
    return std::any_of(stages.begin(), stages.end(), [&](const Stage& s) {
        return std::any_of(s.options.begin(), s.options.end(), [&](const StageOption& o) { return o.name == name; });
    });
}

const OtherName* known(const std::vector<Stage>& stages, const std::string& theirs) {
    return cli::other_name(theirs, [&](std::string_view ours) { return has(stages, ours); });
}

bool says_nothing(const std::string& value) {
    return value.empty() || value == "0" || value == "0%" || value == "\"\"";
}

using ValueOf = std::function<std::string(std::string_view key)>;

// Whether a setting asks for nothing: by itself, or because of another one.
bool idle(const std::string& name, const std::string& value, const ValueOf& value_of) {
    const auto none = [&](const char* key) { return says_nothing(value_of(key)); };
    if (says_nothing(value)) return true;
    if (name.starts_with("support-material-")) return value_of("support-material") != "1";
    if (name == "skirts" || name == "skirt-loops") return true; // told by its distance
    if (name == "skirt-distance") return none("skirts") && none("skirt-loops");
    if (name == "brim-type") return value == "no_brim" || value == "outer_only"; // the only kind there is here
    if (name == "brim-width") return value_of("brim-type") == "no_brim";
    if (name == "nozzle-diameter") return !none("extrusion-width") || !none("line-width"); // else as wide as the bead
    if (name == "filament-shrink" || name == "filament-shrinkage-compensation-z")
        return value == "100%" || value == "100";
    return false;
}

// Our words for a setting that asks for something; none if it has no meaning here.
std::optional<std::string> word_for(const SlicerSetting& s, const std::vector<Stage>& stages, const ValueOf& value_of) {
    const std::string name = dashed(s.key);
    if (std::find(std::begin(kSame), std::end(kSame), name) != std::end(kSame)) return option_of(name, s.value);
    const OtherName* n = known(stages, name);
    if (n == nullptr) return std::nullopt;
    const std::string brim = value_of("brim-type");
    if (name == "brim-width" && !brim.empty() && !brim.starts_with("outer_")) return std::nullopt;
    try {
        return translated(*n, s.value);
    } catch (const Error&) { // a value of another kind
        return std::nullopt;
    }
}

// A file says shrinkage in x and y and in z apart; here it is one option.
void join_shrinkages(std::vector<std::string>& words) {
    const std::string option = "--shrinkage=", flat = option + "0,0,";
    const auto z = std::find_if(words.begin(), words.end(), [&](const std::string& w) { return w.starts_with(flat); });
    const auto xy = std::find_if(words.begin(), words.end(),
                                 [&](const std::string& w) { return w.starts_with(option) && !w.starts_with(flat); });
    if (z == words.end() || xy == words.end()) return;
    *xy = xy->substr(0, xy->rfind(',') + 1) + z->substr(flat.size());
    words.erase(z);
}

// What of a file has a meaning here.
void load(const std::string& file, const std::vector<Stage>& stages, Translated& out) {
    const std::vector<SlicerSetting> all = slicer_settings(file);
    const ValueOf value_of = [&](std::string_view key) {
        const auto at =
            std::find_if(all.begin(), all.end(), [&](const SlicerSetting& s) { return dashed(s.key) == key; });
        return at == all.end() ? std::string() : at->value;
    };
    for (const SlicerSetting& s : all) {
        if (idle(dashed(s.key), s.value, value_of)) continue;
        if (const auto word = word_for(s, stages, value_of))
            out.words.push_back(*word);
        else
            out.left.push_back(s.key);
    }
    join_shrinkages(out.words);
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

Translated translated(const std::vector<std::string>& words, const std::vector<Stage>& stages) {
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
        const OtherName* n = typed.empty() || has(stages, typed) ? nullptr : known(stages, typed);
        if (typed == "load") {
            load(value(), stages, out);
        } else if (typed == "set" || typed == "rotate" || typed == "scale") {
            rest.push_back(option_of(typed, own_value(typed, value())));
        } else if (n != nullptr) {
            const std::string given = n->value == Value::flag && equal == std::string::npos ? "1" : value();
            const auto ours = translated(*n, given);
            if (!ours)
                throw Error(Exit::usage,
                            "cannot use '" + option_of(typed, given) + "'; here it is '" + cli::ours_of(*n) + "'");
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
