#include "ingest/remarks.hpp"

#include "machine/codes.hpp"
#include "machine/type_names.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace filum::ingest {

namespace {

using machine::trimmed;
using toolpath::Feature;
using toolpath::Role;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// True if both texts are equal, without regard to case.
bool same(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

// The rest of `text` after `key`; none if it does not begin with `key`.
std::optional<std::string_view> behind(std::string_view text, std::string_view key) {
    if (text.size() < key.size() || !same(text.substr(0, key.size()), key)) return std::nullopt;
    return trimmed(text.substr(key.size()));
}

std::optional<double> number(std::string_view text) {
    double v = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), v).ec != std::errc{}) return std::nullopt;
    return v;
}

// Names of features in PrusaSlicer, SuperSlicer, OrcaSlicer, Bambu Studio and Cura.
constexpr std::pair<std::string_view, Feature> kNames[] = {
    {"External perimeter", Feature::outer_wall},
    {"Perimeter", Feature::wall},
    {"Internal perimeter", Feature::wall},
    {"Overhang perimeter", Feature::wall},
    {"Internal infill", Feature::infill},
    {"Solid infill", Feature::solid},
    {"Top solid infill", Feature::top},
    {"Ironing", Feature::ironing},
    {"Bridge infill", Feature::bridge},
    {"Internal bridge infill", Feature::bridge},
    {"Gap fill", Feature::gap},
    {"Thin wall", Feature::outer_wall},
    {"Skirt", Feature::skirt},
    {"Skirt/Brim", Feature::skirt},
    {"Support material", Feature::support},
    {"Support material interface", Feature::interface},
    {"Wipe tower", Feature::tower},
    {"Outer wall", Feature::outer_wall},
    {"Inner wall", Feature::wall},
    {"Overhang wall", Feature::wall},
    {"Sparse infill", Feature::infill},
    {"Internal solid infill", Feature::solid},
    {"Top surface", Feature::top},
    {"Bottom surface", Feature::bottom},
    {"Bridge", Feature::bridge},
    {"Internal Bridge", Feature::bridge},
    {"Gap infill", Feature::gap},
    {"Brim", Feature::skirt},
    {"Support", Feature::support},
    {"Support interface", Feature::interface},
    {"Support transition", Feature::support},
    {"Prime tower", Feature::tower},
    {"WALL-OUTER", Feature::outer_wall},
    {"WALL-INNER", Feature::wall},
    {"SKIN", Feature::solid},
    {"FILL", Feature::infill},
    {"SUPPORT-INTERFACE", Feature::interface},
    {"PRIME-TOWER", Feature::tower},
};

constexpr const char* kOwn = "filum";

// Reads "jog wall": the role and the feature of the beads that follow, in programs of Filum.
void own_kind(std::string_view text, Remark& to) {
    const auto index_of = [](const auto& names, std::string_view name) {
        return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const auto blank = text.find(' ');
    if (blank == text.npos) return;
    const std::size_t role = index_of(toolpath::kRoleNames, text.substr(0, blank));
    const std::size_t feature = index_of(toolpath::kFeatureNames, trimmed(text.substr(blank)));
    if (role >= toolpath::kRoles || feature >= toolpath::kFeatures || role == static_cast<std::size_t>(Role::travel))
        return;
    to.role = static_cast<Role>(role);
    to.feature = static_cast<Feature>(feature);
}

// Reads the value of "; filament_diameter = 1.75,2.85", mm.
void diameters(std::string_view text, std::vector<double>& to) {
    to.clear();
    while (!text.empty()) {
        const auto comma = std::min(text.find_first_of(",;"), text.size());
        if (const auto v = number(trimmed(text.substr(0, comma))); v && *v > 0) to.push_back(*v);
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
}

void maker(std::string_view comment, ProgramTraits& to) {
    if (!to.by.empty()) return;
    if (behind(comment, "filum program for")) to.by = kOwn;
    for (const auto& [sign, name] : {std::pair{"PrusaSlicer", "PrusaSlicer"},
                                     {"SuperSlicer", "SuperSlicer"},
                                     {"OrcaSlicer", "OrcaSlicer"},
                                     {"BambuStudio", "Bambu Studio"},
                                     {"Cura_SteamEngine", "Cura"},
                                     {"Slic3r", "Slic3r"}})
        if (to.by.empty() && comment.find(sign) != std::string_view::npos) to.by = name;
}

} // namespace

Remark remark_in(std::string_view comment, const ProgramTraits& traits) {
    Remark out;
    if (comment.empty()) return out;
    const auto kind = [&](std::string_view name) {
        if (traits.by == kOwn) {
            out.role = Role::bead;
            out.feature = machine::feature_of_type(name).value_or(Feature::none);
            return;
        }
        out.feature = Feature::none;
        for (const auto& [known, feature] : kNames)
            if (same(known, name)) out.feature = feature;
    };
    if (const auto n = behind(comment, "LAYER:")) {
        out.layer = true;
        if (const auto index = number(*n)) out.layer_index = static_cast<std::int64_t>(*index);
    } else if (same(comment, "LAYER_CHANGE") || same(comment, "CHANGE_LAYER"))
        out.layer = true;
    else if (const auto type = behind(comment, "TYPE:"))
        kind(*type);
    else if (const auto role = traits.by == kOwn ? behind(comment, "ROLE:") : std::nullopt)
        own_kind(*role, out);
    else if (const auto type_of_bambu = behind(comment, "FEATURE:"))
        kind(*type_of_bambu);
    else if (const auto width = behind(comment, "WIDTH:"))
        out.width = number(*width);
    else if (const auto width_of_bambu = behind(comment, "LINE_WIDTH:"))
        out.width = number(*width_of_bambu);
    else if (const auto height = behind(comment, "HEIGHT:"))
        out.height = number(*height);
    else if (const auto height_of_bambu = behind(comment, "LAYER_HEIGHT:"))
        out.height = number(*height_of_bambu);
    if (out.width && !(*out.width > 0)) out.width.reset();
    if (out.height && !(*out.height > 0)) out.height.reset();
    return out;
}

namespace {

// True if the line moves the extruder E.
bool moves_e(std::string_view line) {
    const std::string_view code = machine::trimmed(line.substr(0, line.find_first_of(";(")));
    return code.size() > 1 && (code[0] == 'G' || code[0] == 'g') && code[1] >= '0' && code[1] <= '3' &&
           code.find_first_of("Ee") != code.npos;
}

// Applies the flavour of G-code that a slicer names. True if its extruder can be the axis A.
bool flavour_of(std::string_view flavour, ProgramTraits& out) {
    out.marlin = out.marlin || behind(flavour, "marlin").has_value() || behind(flavour, "Marlin").has_value();
    out.machinekit = out.machinekit || same(flavour, "machinekit");
    out.volumetric = out.volumetric || same(flavour, "UltiGCode");
    constexpr std::array kByA{"mach3", "machinekit", "makerware", "sailfish"};
    return std::ranges::any_of(kByA, [&](const char* name) { return same(flavour, name); });
}

} // namespace

ProgramTraits traits_of(std::string_view program) {
    ProgramTraits out;
    bool by_a = false, by_e = false; // the flavour allows the axis A; a move has the word E
    while (!program.empty()) {
        const std::size_t end = std::min(program.find('\n'), program.size());
        const std::string_view line = program.substr(0, end);
        program.remove_prefix(std::min(end + 1, program.size()));
        by_e = by_e || moves_e(line);
        if (line.find_first_of(";(") == std::string_view::npos) continue;
        const machine::CodeLine split(line);
        const std::string_view comment = split.comment();
        maker(comment, out);
        const Remark remark = remark_in(comment, out);
        out.layers = out.layers || remark.layer;
        if (remark.layer_index) out.lowest_layer = std::min(out.lowest_layer, *remark.layer_index);
        if (const auto d = behind(comment, "filament_diameter =")) diameters(*d, out.diameters);
        if (const auto d = behind(comment, "filament_diameter:")) diameters(*d, out.diameters);
        for (const char* name : {"FLAVOR:", "gcode_flavor ="})
            if (const auto flavour = behind(comment, name)) by_a = flavour_of(*flavour, out) || by_a;
        if (const auto on = behind(comment, "use_volumetric_e ="))
            out.volumetric = out.volumetric || number(*on).value_or(0) == 1;
    }
    if (by_a && !by_e) out.extruder = 'A';
    return out;
}

} // namespace filum::ingest
