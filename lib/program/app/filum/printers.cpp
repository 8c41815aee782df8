#include "app/filum/printers.hpp"

#include "app/filum/slicer_presets.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "machine/profile.hpp"
#include "stream/sink.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

namespace filum::app::filum {

namespace {

constexpr std::size_t kMostNamed = 8; // most candidates in a message

// Settings of a common filament, for printers without a preset of it.
struct CommonFilament {
    const char* name;
    int first_nozzle, nozzle, first_bed, bed; // degrees Celsius
    double flow;                              // mm3/s
    double density;                           // g/cm3
};
constexpr CommonFilament kFilaments[] = {{"pla", 215, 210, 60, 60, 12, 1.24},
                                         {"petg", 235, 240, 80, 85, 8, 1.27},
                                         {"abs", 255, 255, 100, 100, 11, 1.04},
                                         {"tpu", 230, 230, 50, 50, 3, 1.21}};

std::string in_lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// Whether a name holds all words, in upper or lower case.
bool answers(const std::string& name, const std::vector<std::string>& words) {
    const std::string in = in_lower_case(name);
    return std::ranges::all_of(
        words, [&](const std::string& word) { return in.find(in_lower_case(word)) != std::string::npos; });
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> out;
    for (std::string word; in >> word;) out.push_back(word);
    return out;
}

// The name that is meant: the only one, or the one that all others begin with; "" if there is none.
std::string meant_of(std::vector<std::string> names) {
    if (names.empty()) return "";
    std::ranges::sort(names, {}, [](const std::string& n) { return std::pair(n.size(), n); });
    const std::string& shortest = names.front();
    const bool variants =
        std::ranges::all_of(names, [&](const std::string& name) { return name.starts_with(shortest); });
    return variants ? shortest : "";
}

// The name of the preset that the user's `name` means.  Throws Error(usage) if it is unknown or ambiguous.
std::string preset_name(PresetShelf& shelf, PresetKind kind, const std::string& name) {
    if (shelf.find(kind, name)) return name;
    std::vector<std::string> all, found;
    for (const KnownPreset& preset : shelf.known(kind)) all.push_back(preset.name);
    std::ranges::copy_if(all, std::back_inserter(found),
                         [&](const std::string& preset) { return answers(preset, words_of(name)); });
    if (std::string meant = meant_of(found); !meant.empty()) return meant;
    const std::string what =
        std::string(kind == PresetKind::print ? "print profile" : name_of(kind)) + " '" + name + "'";
    if (found.empty()) {
        if (kind == PresetKind::printer) std::ranges::copy(machine::profile_names(), std::back_inserter(all));
        const std::string near = did_you_mean(name, all);
        throw Error(Exit::usage, "unknown " + what + (near.empty() ? "; see 'filum printers'" : near));
    }
    std::string list;
    for (std::size_t i = 0; i < std::min(found.size(), kMostNamed); ++i)
        list += std::string(i == 0 ? "'" : ", '") + found[i] + "'";
    if (found.size() > kMostNamed) list += " and " + std::to_string(found.size() - kMostNamed) + " more";
    throw Error(Exit::usage, "cannot choose the " + what + ": it can be " + list + "; give the whole name");
}

const CommonFilament* common(const std::string& name) {
    const auto* at =
        std::ranges::find(kFilaments, in_lower_case(name), [](const CommonFilament& f) { return std::string(f.name); });
    return at == std::end(kFilaments) ? nullptr : at;
}

// The settings of a filament, with the keys of the printer's slicer.
SlicerFile settings_of(const CommonFilament& f, Slicer slicer) {
    SlicerFile out;
    out.slicer = slicer;
    const auto put = [&](const std::string& key, double value) {
        std::ostringstream text;
        text << value;
        out.settings.push_back({key, text.str()});
    };
    if (slicer == Slicer::orca || slicer == Slicer::bambu) {
        put("nozzle_temperature", f.nozzle);
        put("nozzle_temperature_initial_layer", f.first_nozzle);
        for (const char* plate : {"cool_plate_temp", "eng_plate_temp", "hot_plate_temp", "textured_plate_temp",
                                  "supertack_plate_temp", "textured_cool_plate_temp"}) {
            put(plate, f.bed);
            put(std::string(plate) + "_initial_layer", f.first_bed);
        }
    } else {
        put("temperature", f.nozzle);
        put("first_layer_temperature", f.first_nozzle);
        put("bed_temperature", f.bed);
        put("first_layer_bed_temperature", f.first_bed);
    }
    put("filament_max_volumetric_speed", f.flow);
    put("filament_density", f.density);
    std::string type = f.name;
    std::ranges::transform(type, type.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    out.settings.push_back({"filament_type", type});
    return out;
}

bool is_own(const std::string& name) {
    const auto own = machine::profile_names();
    return std::ranges::find(own, name) != own.end() || name.find('/') != std::string::npos || name.ends_with(".toml");
}

} // namespace

std::vector<std::string> PrinterNames::words() const {
    std::vector<std::string> out;
    if (!printer.empty()) out.push_back("--printer=" + printer);
    if (!print.empty()) out.push_back("--print-profile=" + print);
    if (!filament.empty()) out.push_back("--filament=" + filament);
    return out;
}

bool PrinterNames::take(const std::string& word) {
    const std::pair<const char*, std::string*> options[] = {
        {"--printer=", &printer}, {"--print-profile=", &print}, {"--filament=", &filament}};
    for (const auto& [option, value] : options) {
        if (!word.starts_with(option)) continue;
        *value = word.substr(std::string(option).size());
        return true;
    }
    return false;
}

ChosenPrinter chosen_printer(const PrinterNames& names) {
    ChosenPrinter out;
    PresetShelf shelf("");
    PresetNames presets;
    const auto preset = [&](PresetKind kind) -> std::string& { return presets[static_cast<std::size_t>(kind)]; };
    const bool own = is_own(names.printer);
    if (own) out.words.push_back("--machine=" + names.printer);
    if (!names.printer.empty() && !own)
        preset(PresetKind::printer) = preset_name(shelf, PresetKind::printer, names.printer);
    if (!names.print.empty()) preset(PresetKind::print) = preset_name(shelf, PresetKind::print, names.print);
    const CommonFilament* filament = common(names.filament);
    if (!names.filament.empty() && filament == nullptr) {
        if (shelf.known(PresetKind::filament).empty())
            throw Error(Exit::usage, "unknown filament '" + names.filament +
                                         "': no slicer's presets were found; Filum knows pla, petg, abs and tpu");
        preset(PresetKind::filament) = preset_name(shelf, PresetKind::filament, names.filament);
    }
    if (!std::ranges::all_of(presets, &std::string::empty))
        out.settings.push_back(settings_of_presets(shelf, presets, "slicers' presets"));
    if (filament != nullptr)
        out.settings.push_back(
            settings_of(*filament, out.settings.empty() ? Slicer::unknown : out.settings.front().slicer));
    return out;
}

int show_printers(const std::vector<std::string>& words) {
    const bool names_only = !words.empty() && words.front() == "--names";
    const std::vector<std::string> wanted(words.begin() + (names_only ? 1 : 0), words.end());
    std::string out;
    const auto add = [&](const std::string& name, const std::string& about) {
        if (!answers(name, wanted) && !(answers(about, wanted) && !names_only)) return;
        std::string line = name;
        if (!names_only) {
            line.resize(std::max<std::size_t>(line.size() + 2, 50), ' ');
            line += about;
        }
        out += line + "\n";
    };
    for (const std::string& name : machine::profile_names()) add(name, "Filum: " + machine::load_profile(name).about);
    PresetShelf shelf("");
    for (const KnownPreset& preset : shelf.known(PresetKind::printer)) add(preset.name, preset.file);
    if (out.empty())
        throw Error(Exit::usage, "no printer has such a name; 'filum printers' lists all, and FILUM_PRESETS names "
                                 "further folders of presets");
    stream::Sink to("-", stream::Sink::Content::text);
    to.write(out);
    to.commit();
    return 0;
}

} // namespace filum::app::filum
