#include "app/filum/slicer_names.hpp"

#include "app/filum/distribute.hpp"
#include "app/filum/printers.hpp"
#include "app/filum/slicer_project.hpp"
#include "app/filum/slicer_settings.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "cli/other_names.hpp"
#include "cli/other_values.hpp"
#include "machine/profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <tuple>

namespace filum::app::filum {

namespace {

using cli::OtherName;
using cli::Value;

std::string option_of(const std::string& name, const std::string& value) {
    std::string out = "--";
    out.append(name).append("=").append(value);
    return out;
}

bool has(const std::vector<Stage>& stages, std::string_view name) {
    return std::any_of(stages.begin(), stages.end(), [&](const Stage& s) {
        return std::any_of(s.options.begin(), s.options.end(),
                           [&](const StageOption& o) { return o.name == name && !has_own_meaning(s.name, name); });
    });
}

const OtherName* known(const std::vector<Stage>& stages, const std::string& theirs) {
    return cli::other_name(theirs, [&](std::string_view ours) { return has(stages, ours); });
}

// A slicer's project among the files of --load.
struct LoadedProject {
    std::string file;
    bool printed = false; // it is the part, too
    bool alone = true;    // it is printed once
    int plate = 1;
};

// Makes options of the bodies in a project, if its part is printed.  Otherwise a remark reports that they are left out.
void load_bodies(const LoadedProject& project, bool supports, const std::vector<Stage>& stages,
                 SlicerTranslation& out) {
    const ProjectBodies there = project_bodies(project.file, project.plate);
    const std::tuple<bool, const char*, const char*> kinds[] = {
        {there.modifiers, "modifier", "bodies that change settings"},
        {there.wanted && supports, "support-in", "places for supports"},
        {there.unwanted && supports, "no-support-in", "places without supports"},
        {there.seams && project.alone, "seam-in", "faces painted for seams"}};
    for (const auto& [any, option, name] : kinds) {
        if (!any) continue;
        if (project.printed && has(stages, option))
            out.words.push_back(option_of(option, project.file));
        else
            out.remarks.push_back(std::string(name) + " in '" + project.file +
                                  "' left out: it is not the part that is printed");
    }
}

// Whether a value of a slicer's file has no effect: it is empty, off, or G-code without a command.
bool says_nothing(const std::string& value) {
    for (const char* off :
         {"", "0", "0%", "\"\"", "none", "nil", "disabled", "no", "by layer", "FFF", "E", "0x0", "all_at_once", "[]"})
        if (value == off) return true;
    std::size_t at = 0;
    while (at < value.size()) { // in such files the letters \n stand for a line end
        const std::size_t end = std::min(value.find("\\n", at), value.size());
        const std::size_t first = value.find_first_not_of(" \t\"", at);
        if (first < end && value[first] != ';') return false;
        at = end + 2;
    }
    return true;
}

// The last value of an option among the words; "" if the option is not there.
std::string last_value(const std::vector<std::string>& words, const std::string& name) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].starts_with(name + "=")) out = words[i].substr(name.size() + 1);
        if (words[i] == name && i + 1 < words.size()) out = words[i + 1];
    }
    return out;
}

// The profile of the job's machine; none if it cannot be read, which print.cpp reports.
std::optional<machine::Profile> machine_profile(const std::vector<std::string>& words,
                                                const std::vector<Stage>& stages) {
    std::string machine = last_value(words, "--machine");
    for (const Stage& s : stages)
        for (const StageOption& o : s.options)
            if (machine.empty() && s.name == "postproc" && o.name == "machine") machine = o.value;
    if (machine.empty()) return std::nullopt;
    try {
        return machine::load_profile(machine, last_value(words, "--set"));
    } catch (const Error&) {
        return std::nullopt;
    }
}

// Removes settings for which the machine has no code: those of the fan, accelerations by role, and pictures.
void leave_out_codes(SlicerWishes& all, const machine::Profile& machine) {
    const auto drop = [&](const std::string& codes, const char* start, const char* end, const char* key,
                          const char* what) {
        if (!codes.empty()) return;
        const auto count = std::erase_if(all.words, [&](const std::string& word) {
            return word.starts_with(start) && word.substr(0, word.find('=', 6)).ends_with(end);
        });
        if (count > 0)
            all.remarks.push_back(std::string(what) + " of the settings not used: machine '" + machine.name +
                                  "' has no " + key);
    };
    if (machine.format.comments != machine::CommentStyle::semicolon)
        std::erase_if(all.words, [](const std::string& word) { return word.starts_with("--thumbnails="); });
    drop(machine.features.set_fan, "--set=cooling.", "", "features.set_fan", "the fan's speeds");
    drop(machine.features.set_fan, "--set=overhang.fans", "", "features.set_fan", "the fan's speeds of overhangs");
    drop(machine.features.set_acceleration, "--set=features.", "acceleration", "features.set_acceleration",
         "accelerations by role");
}

// Limits the speeds of a file to those of the machine, with a remark on each change.
void limit_speeds(SlicerWishes& all, const machine::Motion& motion) {
    const std::string start = "--set=feeds.";
    for (const ReadSetting& s : all.settings)
        for (const std::string& word : s.words) {
            if (!word.starts_with(start) || word.ends_with("=true")) continue;
            const double most = word.starts_with(start + "z=") ? motion.max_speed_z : motion.max_speed;
            const auto equal = word.find('=', start.size());
            if (!(parse_number(word.substr(equal + 1), s.key) > most)) continue;
            std::ranges::replace(all.words, word, word.substr(0, equal + 1) + shortest_text(most));
            all.remarks.push_back(s.key + " = " + s.value + " is above the machine's limit: " + shortest_text(most) +
                                  " mm/s taken");
        }
}

// Whether a file says how hot the nozzle is.
bool names_temperature(const std::vector<SlicerFile>& read) {
    return std::ranges::any_of(read, [](const SlicerFile& file) {
        return std::ranges::any_of(file.settings, [](const SlicerSetting& s) {
            return s.key == "temperature" || s.key == "first_layer_temperature" || s.key == "nozzle_temperature" ||
                   s.key == "nozzle_temperature_initial_layer" || s.key == "material_print_temperature" ||
                   s.key == "default_material_print_temperature";
        });
    });
}

// Makes the printer that the files describe the machine, unless the user names another one.
void use_machine(const std::vector<SlicerFile>& read, std::vector<std::string> sources,
                 const std::vector<std::string>& words, SlicerTranslation& out) {
    auto machine = std::make_shared<SlicerMachine>(read, std::move(sources));
    if (!machine->any()) return;
    if (!last_value(words, "--machine").empty()) {
        out.remarks.push_back("the printer of --load (its G-code, bed and firmware) is not used: --machine is " +
                              last_value(words, "--machine"));
        return;
    }
    if (!names_temperature(read) && last_value(words, "--set").find("nozzle_temp") == std::string::npos)
        out.remarks.emplace_back("no filament in the files: nozzle and bed have the temperatures that the slicer has "
                                 "without one; load a filament, too, or add --temperature and --bed-temperature");
    out.words.push_back(option_of("machine", machine->path()));
    out.machine = std::move(machine);
}

// Removes temperatures, since the G-code of the files' own printer heats.
void leave_to_machine(SlicerWishes& all) {
    std::erase_if(all.words, [](const std::string& word) {
        for (const char* name : {"nozzle_temp=", "first_nozzle_temp=", "bed_temp=", "first_bed_temp="})
            if (word.starts_with(std::string("--set=") + name)) return true;
        return false;
    });
    std::erase_if(all.remarks, [](const std::string& remark) { return remark.ends_with("its machine profile says"); });
}

// Adds to `out` the options that the settings make on this machine, and lists the settings that are not used.  Returns
// whether the settings ask for supports.
bool use_settings(const SlicerFile& file, const std::optional<machine::Profile>& machine,
                  const std::vector<Stage>& stages, SlicerTranslation& out) {
    constexpr std::string_view kVase = "vase"; // an option of `filum print` itself
    SlicerWishes all = wishes(file, [&](std::string_view name) { return name == kVase || has(stages, name); });
    if (out.machine != nullptr) leave_to_machine(all);
    if (machine) {
        limit_speeds(all, machine->motion);
        leave_out_codes(all, *machine);
    }
    out.words.insert(out.words.end(), all.words.begin(), all.words.end());
    std::ranges::move(all.remarks, std::back_inserter(out.remarks));
    for (const ReadSetting& s : all.settings) {
        if (says_nothing(s.value)) continue;
        if (s.use == Use::harm)
            out.harmful.push_back(s.key);
        else if (s.use == Use::later || s.use == Use::unknown)
            out.left.push_back(s.key);
    }
    return all.supports;
}

// Makes --pause-at of the pauses and changes of colour that a printed project has by height, if the machine can wait.
void load_codes(const LoadedProject& project, const std::optional<machine::Profile>& machine,
                const std::vector<std::string>& typed, SlicerTranslation& out) {
    if (!project.printed || !last_value(typed, "--pause-at").empty()) return;
    const std::string height = last_value(out.words, "--layer-height");
    constexpr double kUsualHeight = 0.2; // mm, of slice
    ProjectCodes codes = project_codes(project.file, project.plate,
                                       height.empty() ? kUsualHeight : parse_number(height, "layer_height"));
    std::ranges::move(codes.remarks, std::back_inserter(out.remarks));
    if (codes.pauses.empty()) return;
    if (machine && machine->preset == nullptr && machine->templates.pause.empty())
        out.remarks.push_back("pauses of the project not used: machine '" + machine->name + "' has no templates.pause");
    else
        out.words.push_back(option_of("pause-at", codes.pauses));
}

// Removes options of supports that would be errors, as nothing that they need is wanted.  That happens if a slicer
// makes supports only at bodies and painted faces that ask for them.
void leave_out_supports(const std::vector<std::string>& typed, SlicerTranslation& out) {
    const auto any = [&](std::initializer_list<const char*> options) {
        const auto named = [&](const std::string& word) {
            const std::string name = word.substr(0, word.find('='));
            return std::ranges::any_of(options, [&](const char* option) { return name == option; });
        };
        return std::ranges::any_of(typed, named) || std::ranges::any_of(out.words, named);
    };
    const auto drop = [&](const std::string& option) {
        return std::erase_if(out.words, [&](const std::string& word) { return word.starts_with(option + "="); });
    };
    std::size_t count = 0;
    if (!any({"--support"})) count += drop("--support-angle");
    if (!any({"--support", "--support-in"})) count += drop("--support-on") + drop("--beside");
    if (any({"--support", "--support-in", "--raft"})) return;
    count += drop("--support-spacing") + drop("--support-width") + drop("--interface");
    if (count > 0)
        out.remarks.emplace_back("no supports: the settings want them only at bodies and faces that ask for them, and "
                                 "there are none; add --support");
}

// The number of the plate in --plate; 1 if there is none, or if it is wrong, which `slice` reports.
int plate_of(const std::vector<std::string>& words) {
    const std::string text = last_value(words, "--plate");
    return text.empty() || text.size() > 3 || text.find_first_not_of("0123456789") != std::string::npos
               ? 1
               : std::stoi(text);
}

// Adds the settings of the printer and of all files, then the bodies in projects.  `words`: those that the user typed.
void load(const PrinterNames& printer, const std::vector<std::string>& files, const std::vector<std::string>& words,
          const std::vector<Stage>& stages, SlicerTranslation& out) {
    if (files.empty() && !printer.any()) return;
    ChosenPrinter chosen = chosen_printer(printer);
    out.words = chosen.words;
    std::vector<SlicerFile> read = std::move(chosen.settings);
    const int plate = plate_of(words);
    const bool alone = std::ranges::all_of(std::array{"--copies", "--grid", "--wells"},
                                           [&](const char* option) { return last_value(words, option).empty(); });
    for (const std::string& file : files) read.push_back(slicer_file(file, plate));
    std::vector<std::string> all = out.words;
    all.insert(all.end(), words.begin(), words.end());
    std::vector<std::string> sources = printer.words();
    sources.insert(sources.end(), files.begin(), files.end());
    use_machine(read, std::move(sources), all, out);
    if (out.machine != nullptr) all.insert(all.begin(), out.words.back());
    const auto machine = machine_profile(all, stages);
    bool supports = false;
    for (const SlicerFile& file : merged(std::move(read)))
        supports = use_settings(file, machine, stages, out) || supports;
    for (const std::string& file : files) {
        const LoadedProject project{file, std::ranges::find(words, file) != words.end(), alone, plate};
        load_bodies(project, supports, stages, out);
        load_codes(project, machine, words, out);
    }
    leave_out_supports(words, out);
}

// The member of `names` for an option that names a printer, a print profile or a filament; null for other options.
std::string* printer_name(PrinterNames& names, const std::string& option) {
    if (option == "printer" || option == "printer-profile") return &names.printer;
    if (option == "print-profile") return &names.print;
    if (option == "filament" || option == "material-profile") return &names.filament;
    return nullptr;
}

// Converts a slicer's value of an option that Filum has, as in --rotate 45, --scale 150%, --infill 15 and
// --infill-pattern gyroid.  Other values stay as they are.
std::string own_value(const std::string& name, const std::string& value) {
    if (name == "rotate" && value.find(',') == std::string::npos && !value.empty()) return "0,0," + value;
    if (name == "scale" && value.ends_with('%'))
        return shortest_text(parse_number(value.substr(0, value.size() - 1), "--scale") / 100);
    if (name == "infill" && !value.empty() && value.find_first_not_of("0123456789.") == std::string::npos &&
        parse_number(value, "--infill") > 1)
        return value + "%";
    if (name == "infill-pattern") { // names of Filum, such as rows, stay
        const auto ours = cli::our_word({"fill-pattern", "infill-pattern", Value::pattern}, value);
        if (ours) return ours->substr(ours->find('=') + 1);
    }
    return value;
}

// Joins all --set to one, at the place of the first.
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

// The project (3MF) that is the only part, if it holds settings of a slicer; "" for any other job.
std::string own_project(const std::vector<std::string>& words, const std::vector<Stage>& stages) {
    try {
        const std::vector<std::string> inputs = distribute(words, stages).inputs;
        if (inputs.size() != 1 || !inputs[0].ends_with(".3mf")) return "";
        (void)slicer_file(inputs[0], plate_of(words));
        return inputs[0];
    } catch (const Error&) { // a file without settings, or wrong options, which are reported later
        return "";
    }
}

// Loads the settings of the project that is printed.  On its own printer the part stays where the project has it.
void load_project(const std::string& project, const std::vector<std::string>& words, const std::vector<Stage>& stages,
                  SlicerTranslation& out) {
    out.remarks.push_back("the settings in '" + project + "' are used; --load none prints without them");
    load({}, {project}, words, stages, out);
    const auto typed = [&](const char* option) { return !last_value(words, option).empty(); };
    const bool first_plate = last_value(words, "--plate").empty() || last_value(words, "--plate") == "1";
    if (out.machine != nullptr && first_plate && !typed("--place") && !typed("--rotate") && !typed("--translate") &&
        !typed("--copies"))
        out.words.push_back(option_of("place", "as-is"));
}

} // namespace

SlicerTranslation translated(const std::vector<std::string>& words, const std::vector<Stage>& stages) {
    SlicerTranslation out;
    std::vector<std::string> rest, files;
    PrinterNames printer;
    std::size_t i = 0;
    for (; i < words.size() && words[i] != "--"; ++i) {
        const std::string& word = words[i];
        const auto equal = word.find('=');
        const std::string typed =
            word.starts_with("--") ? word.substr(2, equal == std::string::npos ? equal : equal - 2) : "";
        const auto value = [&]() -> std::string {
            if (equal != std::string::npos) return word.substr(equal + 1);
            return value_behind(words, i);
        };
        const OtherName* n = typed.empty() || has(stages, typed) ? nullptr : known(stages, typed);
        if (typed == "load") {
            files.push_back(value());
        } else if (std::string* name = printer_name(printer, typed)) {
            *name = value();
        } else if (typed == "set" || typed == "rotate" || typed == "scale" || typed == "infill" ||
                   typed == "infill-pattern") {
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
    join_sets(rest);
    const bool loads = !files.empty() || printer.any();
    std::erase(files, "none");
    if (const std::string project = loads ? "" : own_project(rest, stages); !project.empty())
        load_project(project, rest, stages, out);
    else
        load(printer, files, rest, stages, out);
    out.words.insert(out.words.end(), rest.begin(), rest.end());
    out.words.insert(out.words.end(), words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
    join_sets(out.words);
    return out;
}

} // namespace filum::app::filum
