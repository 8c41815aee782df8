#include "app/filum/slicer_file.hpp"

#include "app/filum/cura_file.hpp"
#include "app/filum/cura_stack.hpp"
#include "app/filum/slicer_presets.hpp"
#include "app/filum/slicer_project.hpp"
#include "app/filum/slicer_values.hpp"
#include "archive/zip.hpp"
#include "base/error.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace filum::app::filum {

namespace {

bool has_key(const std::vector<SlicerSetting>& settings, std::initializer_list<const char*> keys) {
    return std::ranges::any_of(settings,
                               [&](const SlicerSetting& s) { return std::ranges::find(keys, s.key) != keys.end(); });
}

constexpr std::pair<const char*, const char*> kMarks[] = {
    {"; CONFIG_BLOCK_START", "; CONFIG_BLOCK_END"},
    {"; prusaslicer_config = begin", "; prusaslicer_config = end"},
    {"; superslicer_config = begin", "; superslicer_config = end"}};

// Whether a block of settings begins in a G-code file and does not end.
bool block_is_cut(const std::string& text) {
    return std::ranges::any_of(kMarks, [&](const auto& mark) {
        const auto from = text.find(mark.first);
        return from != std::string::npos && text.find(mark.second, from) == std::string::npos;
    });
}

// The part of a G-code file between the marks of the slicer's block of settings; the whole text if it has no marks.
std::string config_block(const std::string& text) {
    for (const auto& [begin, end] : kMarks) {
        const auto from = text.find(begin);
        if (from == std::string::npos) continue;
        const auto first = text.find('\n', from);
        return first == std::string::npos ? "" : text.substr(first, text.find(end, first) - first);
    }
    return text;
}

// Whether the text is G-code: it begins with a comment, or the file's name has the ending of a program.
bool is_program(const std::string& text, const std::string& file) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && text[first] == ';') return true;
    for (const char* ending : {".gcode", ".gco", ".g", ".nc", ".ngc"})
        if (file.ends_with(ending)) return true;
    return false;
}

bool is_bundle(const std::string& text) {
    return std::ranges::any_of(sections(text, Lines::plain),
                               [](const Section& s) { return s.heading.find(':') != std::string::npos; });
}

SlicerFile of_text(const std::string& text, const NamedPresets& named) {
    if (!is_json(text) && is_program(text, named.file)) {
        SlicerFile out;
        out.settings = all_settings(config_block(text), Lines::commented);
        out.slicer = writer_of(text, out.settings);
        if (block_is_cut(text)) out.remarks.emplace_back("the file is cut short: its block of settings has no end");
        if (!out.settings.empty()) return out;
    }
    return !is_json(text) && is_bundle(text) ? bundle_settings(text, named) : preset_settings(text, named.file);
}

// Whether settings of the two can be read as those of one slicer.
bool fit(Slicer a, Slicer b) { return a == b || a == Slicer::unknown || b == Slicer::unknown; }

} // namespace

Slicer writer_of(const std::string& text, const std::vector<SlicerSetting>& settings) {
    const std::string head = text.substr(0, 1 << 14);
    constexpr std::pair<const char*, Slicer> kNames[] = {
        {"SuperSlicer", Slicer::super},  {"OrcaSlicer", Slicer::orca},   {"BambuStudio", Slicer::bambu},
        {"Bambu Studio", Slicer::bambu}, {"PrusaSlicer", Slicer::prusa}, {"by Slic3r", Slicer::slic3r}};
    for (const auto& [name, slicer] : kNames)
        if (head.find(name) != std::string::npos) return slicer;
    if (is_json(text) || has_key(settings, {"sparse_infill_density", "wall_loops", "initial_layer_print_height"}))
        return Slicer::orca;
    if (has_key(settings, {"xy_inner_size_compensation", "first_layer_size_compensation", "default_speed",
                           "external_perimeter_extrusion_spacing", "hole_to_polyhole"}))
        return Slicer::super;
    return has_key(settings, {"perimeter_generator", "machine_limits_usage", "gcode_label_objects"}) ? Slicer::prusa
                                                                                                     : Slicer::unknown;
}

const SlicerSetting* find_setting(const std::vector<SlicerSetting>& all, std::string_view key) {
    const auto at = std::ranges::find(all, key, &SlicerSetting::key);
    return at == all.end() ? nullptr : &*at;
}

void put_setting(std::vector<SlicerSetting>& all, const SlicerSetting& setting) {
    const auto at = std::ranges::find(all, setting.key, &SlicerSetting::key);
    if (at == all.end())
        all.push_back(setting);
    else
        *at = setting;
}

const char* name_of(Slicer slicer) {
    switch (slicer) {
    case Slicer::slic3r:
        return "Slic3r";
    case Slicer::prusa:
        return "PrusaSlicer";
    case Slicer::super:
        return "SuperSlicer";
    case Slicer::orca:
        return "OrcaSlicer";
    case Slicer::bambu:
        return "Bambu Studio";
    case Slicer::cura:
        return "Cura";
    case Slicer::unknown:
        break;
    }
    return "a slicer that the file does not name";
}

SlicerFile slicer_file(const std::string& word, int plate) {
    const NamedPresets named = named_presets(word);
    const std::string& file = named.file;
    const std::string text = content_of(file);
    if (text.starts_with("GCDE"))
        throw Error(Exit::bad_input, "cannot use '" + file +
                                         "': it is binary G-code; save it as plain G-code in its slicer, or export the "
                                         "configuration");
    const bool project = archive::Zip::begins(text);
    if (named.any() && (project || is_json(text) || !is_bundle(text)))
        throw Error(Exit::usage,
                    "cannot use '" + word + "': '" + file + "' is no bundle of presets; load it by its name alone");
    if (!named.any())
        if (auto cura = cura_file(text, file)) return *std::move(cura);
    SlicerFile out = project ? project_settings(text, file, plate) : of_text(text, named);
    refuse_decimal_commas(out, file);
    if (!out.settings.empty()) return out;
    if (is_json(text))
        throw Error(Exit::bad_input, "cannot use '" + file + "': it is no JSON, or holds no settings; export it again");
    throw Error(Exit::bad_input, "cannot use '" + file +
                                     "': it holds no settings of a slicer; export them as an .ini file (lines 'name = "
                                     "value'), or name a project of PrusaSlicer, OrcaSlicer or Bambu Studio (.3mf), a "
                                     "profile of Cura (.curaprofile), or a G-code file of theirs");
}

void put_over(SlicerFile& into, SlicerFile file) {
    if (file.slicer != Slicer::unknown) into.slicer = file.slicer;
    for (SlicerSetting& s : file.settings) {
        std::erase_if(into.settings, [&](const SlicerSetting& before) { return before.key == s.key; });
        into.settings.push_back(std::move(s));
    }
    for (const SlicerSetting& s : file.beneath) put_setting(into.beneath, s);
    std::ranges::move(file.remarks, std::back_inserter(into.remarks));
}

std::vector<SlicerFile> merged(std::vector<SlicerFile> files) {
    std::vector<SlicerFile> out;
    for (SlicerFile& file : files) {
        if (out.empty() || !fit(out.back().slicer, file.slicer)) {
            out.push_back(std::move(file));
            continue;
        }
        put_over(out.back(), std::move(file));
    }
    for (SlicerFile& file : out)
        if (file.slicer == Slicer::cura) calculate_formulas(file);
    return out;
}

} // namespace filum::app::filum
