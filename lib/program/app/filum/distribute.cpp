#include "app/filum/distribute.hpp"

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/number.hpp"
#include "cli/needs.hpp"
#include "cli/other_names.hpp"
#include "machine/profile.hpp"
#include "plate/grid.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>

namespace filum::app::filum {

namespace {

constexpr const char* kSee = "; see 'filum help print'";

// An option as the user typed it: --stage.name=value.  `stage` is empty for an option for all stages.
struct Word {
    std::string stage, name;
    std::optional<std::string> value;
};

Word split(const std::string& word) {
    Word out;
    const auto equal = word.find('=');
    if (equal != std::string::npos) out.value = word.substr(equal + 1);
    out.name = word.substr(2, equal == std::string::npos ? equal : equal - 2);
    const auto dot = out.name.find('.');
    if (dot == std::string::npos) return out;
    out.stage = out.name.substr(0, dot);
    out.name = out.name.substr(dot + 1);
    return out;
}

const StageOption* find(const Stage& stage, const std::string& name) {
    const auto at =
        std::find_if(stage.options.begin(), stage.options.end(), [&](const auto& o) { return o.name == name; });
    return at == stage.options.end() ? nullptr : &*at;
}

// The options of one stage.  `all`: those that were given to all stages; `own`: those for this stage, which win.
struct StageArguments {
    std::vector<std::string> all, own;
};

bool give(const Word& word, const std::vector<Stage>& stages, std::vector<StageArguments>& to, std::size_t& at,
          const std::vector<std::string>& words) {
    std::optional<std::string> value = word.value;
    bool known = false;
    for (std::size_t s = 0; s < stages.size(); ++s) {
        if (!word.stage.empty() && stages[s].name != word.stage) continue;
        const StageOption* option = find(stages[s], word.name);
        if (option == nullptr || word.name == "output") continue;
        if (word.stage.empty() && has_own_meaning(stages[s].name, word.name)) continue;
        if (option->takes_value && !value) value = value_behind(words, at);
        auto& list = word.stage.empty() ? to[s].all : to[s].own;
        list.push_back("--" + word.name + (value ? "=" + *value : ""));
        known = true;
    }
    return known;
}

} // namespace

namespace {

const std::string* last(const StageArguments& given, const std::string& start) {
    for (const auto* list : {&given.own, &given.all})
        for (auto word = list->rbegin(); word != list->rend(); ++word)
            if (word->starts_with(start)) return &*word;
    return nullptr;
}

// Gives --head=MACHINE to each stage that has the option --head, unless it has a value for it.
void hand_on_machine(const std::vector<Stage>& stages, std::vector<StageArguments>& to) {
    const std::string machine = "--machine=";
    const std::string* word = nullptr;
    for (const StageArguments& g : to)
        if (const auto* found = last(g, machine)) word = found;
    if (word == nullptr) return;
    const std::string name = word->substr(machine.size());
    for (std::size_t s = 0; s < stages.size(); ++s)
        if (find(stages[s], "head") != nullptr && last(to[s], "--head=") == nullptr)
            to[s].all.push_back("--head=" + name);
}

// Gives the option to each stage that has it, unless the stage has a value for it.
void hand_on(const std::string& name, const std::string& value, const std::vector<Stage>& stages,
             std::vector<StageArguments>& to) {
    const std::string start = "--" + name + "=";
    for (std::size_t s = 0; s < stages.size(); ++s)
        if (find(stages[s], name) != nullptr && last(to[s], start) == nullptr) to[s].all.push_back(start + value);
}

// The value of an option in the first stage to which it was given; "" for none.
std::string value_of(const std::string& name, const std::vector<StageArguments>& to) {
    const std::string start = "--" + name + "=";
    for (const StageArguments& given : to)
        if (const std::string* word = last(given, start)) return word->substr(start.size());
    return "";
}

// The diameter of the nozzle that the machine's profile states, mm; 0: none. A profile that cannot be read is left to
// the stage that reads it.
double nozzle_of(const std::string& machine) {
    if (machine.empty()) return 0;
    try {
        return machine::load_profile(machine).extrusion.nozzle;
    } catch (const Error&) {
        return 0;
    }
}

// Beads are as wide as the nozzle that is asked for, or else as the one of the machine. Then layers are half as high.
void hand_on_nozzle(const std::vector<Stage>& stages, std::vector<StageArguments>& to) {
    const std::string nozzle = value_of("nozzle", to);
    if (!nozzle.empty()) return hand_on("bead-width", nozzle, stages, to);
    const double own = value_of("bead-width", to).empty() ? nozzle_of(value_of("machine", to)) : 0;
    if (!(own > 0)) return;
    hand_on("bead-width", shortest_text(own), stages, to);
    hand_on("layer-height", shortest_text(own / 2), stages, to);
}

// Sets options that follow from others.  The single wall of a vase is a helix.  Two or more walls side by side are
// printed flat, layer by layer, since a helix cannot return to its start.  Parts in wells and grids stay in place, and
// travels rise above the walls of wells.  Of several materials each body gets its volume.  In a bath the order keeps
// the distance of the travels, and inner shells come before outer ones.
void hand_on_meant(const Request& request, const std::vector<Stage>& stages, std::vector<StageArguments>& to) {
    const std::string walls = value_of("walls", to), wells = value_of("wells", to);
    if (request.vase) hand_on("lift", walls.empty() || walls == "1" ? "helical" : "ramp", stages, to);
    hand_on_nozzle(stages, to);
    if (!wells.empty() || !value_of("grid", to).empty()) hand_on("place", "as-is", stages, to);
    if (const std::string bath = value_of("bath", to); !bath.empty()) {
        hand_on("clearance", bath, stages, to);
        hand_on("from-inside", "true", stages, to);
    }
    if (!value_of("body", to).empty() && value_of("pattern", to) != "scaffold") hand_on("volume", "exact", stages, to);
    if (!wells.empty() && wells.size() <= 2 && wells.find_first_not_of("0123456789") == std::string::npos)
        hand_on("wall-height", shortest_text(plate::well_plate(std::stol(wells)).depth), stages, to);
}

// Looks up options of the stage: the value in `given`, else the default, and whether the value differs from the
// default.
cli::Lookup lookup(const Stage& stage, const StageArguments& given) {
    return [&](const std::string& name) -> cli::OptionState {
        const StageOption* option = find(stage, name);
        if (option == nullptr) return {};
        const std::string* word = last(given, "--" + name + "=");
        const bool flag = !option->takes_value && last(given, "--" + name) != nullptr;
        const std::string value = word != nullptr ? word->substr(name.size() + 3) : flag ? "true" : option->value;
        return {value, value != option->value};
    };
}

std::string name_in(const std::string& word) { return split(word).name; }

bool idle(const Stage& stage, const StageArguments& given, const std::string& name) {
    const StageOption* option = find(stage, name);
    return option != nullptr && cli::fault(name, option->needs, lookup(stage, given)).has_value();
}

// Gives lengths that suit the beads of a machine with a stated nozzle to infill and supports: as many beads as their
// usual values are beads of .4 mm. With those, beads of some millimetres would lie one on the other.
void hand_on_lengths(const std::vector<Stage>& stages, std::vector<StageArguments>& to) {
    if (!(nozzle_of(value_of("machine", to)) > 0)) return;
    const double bead = std::strtod(value_of("bead-width", to).c_str(), nullptr);
    if (!(bead > 0)) return;                    // the stages refuse it
    constexpr double kUsual = 0.4, kMost = 100; // mm: the usual bead; the most that --support-spacing takes
    const double share = bead / kUsual;
    for (const auto& [name, value] : {std::pair{"bridge", 2 * share},
                                      {"solid-below", 70 * share * share},
                                      {"support-spacing", std::min(kMost, 2.5 * share)},
                                      {"beside", 1 * share}})
        for (std::size_t s = 0; s < stages.size(); ++s)
            if (find(stages[s], name) != nullptr && !idle(stages[s], to[s], name) &&
                last(to[s], std::string("--") + name + "=") == nullptr)
                to[s].all.push_back(std::string("--") + name + "=" + shortest_text(value));
}

// Removes options for all stages from each stage where they have no effect.  If an option has no effect in any stage,
// all stages keep it, and report what it needs.
void keep_effective(const std::vector<Stage>& stages, std::vector<StageArguments>& to) {
    const std::vector<StageArguments> before = to;
    const auto works = [&](const std::string& name) {
        for (std::size_t s = 0; s < stages.size(); ++s)
            if (find(stages[s], name) != nullptr && !idle(stages[s], before[s], name)) return true;
        return false;
    };
    for (std::size_t s = 0; s < stages.size(); ++s)
        std::erase_if(to[s].all, [&](const std::string& word) {
            const std::string name = name_in(word);
            return idle(stages[s], before[s], name) && works(name);
        });
}

[[noreturn]] void unknown(const Word& word, const std::string& typed, const std::vector<Stage>& stages) {
    std::vector<std::string> names{"output", "keep", "picture", "report", "stage", "vase", "dry-run", "quiet"}, folders;
    const std::size_t own = names.size();
    for (const Stage& s : stages) {
        folders.push_back(s.name);
        if (word.stage.empty() || word.stage == s.name)
            for (const StageOption& o : s.options) names.push_back(o.name);
    }
    const bool stage = !word.stage.empty() && names.size() == own;
    const std::string known = stage ? "" : cli::in_our_words(word.name, names);
    const std::string meant = !known.empty() ? known
                              : stage
                                  ? did_you_mean(word.stage, folders, "--")
                                  : did_you_mean(word.name, names, word.stage.empty() ? "--" : "--" + word.stage + ".");
    throw Error(Exit::usage, "unknown option '" + typed +
                                 "': " + (stage ? "the chain has no such stage" : "no stage of the chain has it") +
                                 (meant.empty() ? kSee : meant));
}

} // namespace

namespace {

// The member of `to` that holds the value of an option of `print` itself; null for an option of the stages.
std::string* own_option(const std::string& word, Request& to) {
    const std::string name = word.substr(0, word.find('='));
    if (name == "--keep") return &to.keep;
    if (name == "--picture") return &to.picture;
    if (name == "--report") return &to.report;
    if (name == "--stage") return &to.swapped; // swap() in print.cpp has used it
    return nullptr;
}

} // namespace

const std::string& value_behind(const std::vector<std::string>& words, std::size_t& i) {
    // "-o" and "--keep" are options, "-" is standard input, and "-2.5" a number.
    const auto is_option = [](const std::string& word) {
        return word.size() > 1 && word[0] == '-' &&
               (std::isalpha(static_cast<unsigned char>(word[1])) != 0 || word[1] == '-');
    };
    const std::string option = words[i].substr(0, words[i].find('='));
    if (++i == words.size() || is_option(words[i]))
        throw Error(Exit::usage, "cannot use '" + option + "' without a value" +
                                     (i == words.size() ? "" : ": '" + words[i] + "' is an option") + kSee);
    return words[i];
}

Request distribute(const std::vector<std::string>& words, const std::vector<Stage>& stages) {
    Request out;
    std::vector<StageArguments> given(stages.size());
    bool names_only = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const auto next = [&]() -> const std::string& {
            const std::string& name = value_behind(words, i);
            if (name.empty()) throw Error(Exit::usage, "cannot use '" + word + "' without a file name" + kSee);
            return name;
        };
        const bool option = !names_only && word.starts_with("-") && word != "-";
        if (option && word == "--")
            names_only = true;
        else if (option && (word == "-o" || word == "--output"))
            out.output = next();
        else if (option && word.starts_with("--output="))
            out.output = word.substr(9);
        else if (option && word == "--dry-run")
            out.dry_run = true;
        else if (option && word == "--vase")
            out.vase = true;
        else if (std::string* own = option ? own_option(word, out) : nullptr) {
            const auto equal = word.find('=');
            *own = equal == std::string::npos ? next() : word.substr(equal + 1);
            if (own->empty()) throw Error(Exit::usage, "cannot use '" + word + "' without a name" + kSee);
        } else if (option && (word == "-q" || word == "--quiet")) {
            out.quiet = true;
            for (auto& g : given) g.all.emplace_back("--quiet");
        } else if (option && word.starts_with("--")) {
            if (!give(split(word), stages, given, i, words)) unknown(split(word), word, stages);
        } else if (option) {
            unknown({"", word.substr(1), {}}, word, stages);
        } else if (word.empty()) {
            throw Error(Exit::usage, std::string("cannot use '' as a part: it is no file name") + kSee);
        } else {
            out.inputs.push_back(word);
        }
    }
    hand_on_machine(stages, given);
    hand_on_meant(out, stages, given);
    hand_on_lengths(stages, given);
    keep_effective(stages, given);
    for (StageArguments& g : given) {
        g.all.insert(g.all.end(), g.own.begin(), g.own.end());
        out.arguments.push_back(std::move(g.all));
    }
    return out;
}

} // namespace filum::app::filum
