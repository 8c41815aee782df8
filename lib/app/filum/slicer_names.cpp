#include "app/filum/slicer_names.hpp"

#include "app/filum/slicer_file.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "cli/other_names.hpp"
#include "cli/other_values.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>
#include <tuple>

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
        return cli::our_word(*n, s.value);
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

// Whether a file asks for supports, and if so whether only where bodies or painted faces say.
bool supports_asked(const ValueOf& value_of) {
    return value_of("support-material") == "1" || value_of("enable-support") == "1";
}
bool supports_by_hand(const ValueOf& value_of) {
    return value_of("support-material-auto") == "0" || value_of("support-type").find("(manual)") != std::string::npos;
}

// The bodies of a project whose part is printed; of another part's they are left out.
void load_bodies(const std::string& file, bool printed, const ValueOf& value_of, const std::vector<Stage>& stages,
                 Translated& out) {
    const ProjectBodies there = project_bodies(file);
    const bool supports = supports_asked(value_of);
    const std::tuple<bool, const char*, const char*> kinds[] = {
        {there.modifiers, "modifier", "bodies that change settings"},
        {there.wanted && supports, "support-in", "places for supports"},
        {there.unwanted && supports, "no-support-in", "places without supports"}};
    for (const auto& [any, option, name] : kinds) {
        if (!any) continue;
        if (printed && has(stages, option))
            out.words.push_back(option_of(option, file));
        else
            out.remarks.push_back(std::string(name) + " in '" + file +
                                  "' left out: it is not the part that is printed");
    }
}

// What of a file has a meaning here; `printed`: it is also the part.
void load(const std::string& file, bool printed, const std::vector<Stage>& stages, Translated& out) {
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
    if (supports_asked(value_of) && supports_by_hand(value_of)) std::erase(out.words, "--support");
    load_bodies(file, printed, value_of, stages, out);
}

// --rotate 45, --scale 150%: our options, values of theirs.
std::string own_value(const std::string& name, const std::string& value) {
    if (name == "rotate" && value.find(',') == std::string::npos && !value.empty()) return "0,0," + value;
    if (name == "scale" && value.ends_with('%'))
        return shortest_text(parse_number(value.substr(0, value.size() - 1), "--scale") / 100);
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
    std::vector<std::string> rest, files;
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
            files.push_back(value());
        } else if (typed == "set" || typed == "rotate" || typed == "scale") {
            rest.push_back(option_of(typed, own_value(typed, value())));
        } else if (n != nullptr) {
            const std::string given = n->value == Value::flag && equal == std::string::npos ? "1" : value();
            const auto ours = cli::our_word(*n, given);
            if (!ours)
                throw Error(Exit::usage,
                            "cannot use '" + option_of(typed, given) + "'; here it is '" + cli::ours_of(*n) + "'");
            rest.push_back(*ours);
        } else {
            rest.push_back(word);
        }
    }
    for (const std::string& file : files) load(file, std::ranges::find(rest, file) != rest.end(), stages, out);
    out.words.insert(out.words.end(), rest.begin(), rest.end());
    out.words.insert(out.words.end(), words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
    join_sets(out.words);
    return out;
}

} // namespace filum::app::filum
