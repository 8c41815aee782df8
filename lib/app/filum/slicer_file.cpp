#include "app/filum/slicer_file.hpp"

#include "archive/zip.hpp"
#include "base/error.hpp"
#include "mesh/read.hpp"
#include "wire/json.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace filum::app::filum {

namespace {

std::string trimmed(const std::string& text) {
    const auto from = text.find_first_not_of(" \t\r");
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

bool is_key(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
        return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_' || std::isupper(c) != 0;
    });
}

// How lines with settings look: "name = value", behind a semicolon in comments.
enum class Lines : std::uint8_t { plain, commented };

[[noreturn]] void refuse_bundle(const std::string& section) {
    throw Error(Exit::bad_input, "cannot use the settings: they are a bundle of presets ('[" + section +
                                     "]' and others), and nothing says which hold; export one configuration (in "
                                     "PrusaSlicer: File, Export, Export Config), or name a project");
}

std::vector<SlicerSetting> of_lines(const std::string& text, Lines kind) {
    std::vector<SlicerSetting> out;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        line = trimmed(line);
        const bool comment = line.starts_with(';');
        if (comment != (kind == Lines::commented)) continue;
        if (comment) line = trimmed(line.substr(1));
        if (line.starts_with('[') && line.ends_with(']') && line.find(':') != std::string::npos)
            refuse_bundle(line.substr(1, line.size() - 2));
        const auto equal = line.find('=');
        const std::string key = trimmed(line.substr(0, equal));
        if (equal != std::string::npos && is_key(key)) out.push_back({key, trimmed(line.substr(equal + 1))});
    }
    return out;
}

std::vector<SlicerSetting> of_json(const std::string& text) {
    std::vector<SlicerSetting> out;
    for (const auto& [key, value] : wire::json_values(text)) out.push_back({key, value});
    return out;
}

bool has_key(const SlicerFile& file, std::initializer_list<const char*> keys) {
    return std::ranges::any_of(file.settings,
                               [&](const SlicerSetting& s) { return std::ranges::find(keys, s.key) != keys.end(); });
}

// The slicer that wrote a text: by the name at its beginning, or by keys that only it has.
Slicer writer_of(const std::string& text, const SlicerFile& file, bool json) {
    const std::string head = text.substr(0, 1 << 14);
    constexpr std::pair<const char*, Slicer> kNames[] = {
        {"SuperSlicer", Slicer::super},  {"OrcaSlicer", Slicer::orca},   {"BambuStudio", Slicer::bambu},
        {"Bambu Studio", Slicer::bambu}, {"PrusaSlicer", Slicer::prusa}, {"by Slic3r", Slicer::slic3r}};
    for (const auto& [name, slicer] : kNames)
        if (head.find(name) != std::string::npos) return slicer;
    if (json || has_key(file, {"sparse_infill_density", "wall_loops", "initial_layer_print_height"}))
        return Slicer::orca;
    if (has_key(file, {"xy_inner_size_compensation", "first_layer_size_compensation", "default_speed",
                       "external_perimeter_extrusion_spacing", "hole_to_polyhole"}))
        return Slicer::super;
    return has_key(file, {"perimeter_generator", "machine_limits_usage", "gcode_label_objects"}) ? Slicer::prusa
                                                                                                 : Slicer::unknown;
}

// Of a program, the comments between the marks of its slicer's block; all of them if there are no marks.
std::string config_block(const std::string& text) {
    constexpr std::pair<const char*, const char*> kMarks[] = {
        {"; CONFIG_BLOCK_START", "; CONFIG_BLOCK_END"},
        {"; prusaslicer_config = begin", "; prusaslicer_config = end"},
        {"; superslicer_config = begin", "; superslicer_config = end"}};
    for (const auto& [begin, end] : kMarks) {
        const auto from = text.find(begin);
        if (from == std::string::npos) continue;
        const auto first = text.find('\n', from);
        return first == std::string::npos ? "" : text.substr(first, text.find(end, first) - first);
    }
    return text;
}

// A program begins with a comment, or its name says it.
bool is_program(const std::string& text, const std::string& file) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && text[first] == ';') return true;
    for (const char* ending : {".gcode", ".gco", ".g", ".nc", ".ngc"})
        if (file.ends_with(ending)) return true;
    return false;
}

SlicerFile of_project(const std::string& bytes, const std::string& file) {
    archive::Zip zip(bytes, "'" + file + "'");
    SlicerFile out;
    if (const char* path = "Metadata/Slic3r_PE.config"; zip.has(path)) {
        const std::string text = zip.read(path);
        out.settings = of_lines(text, Lines::commented);
        out.slicer = writer_of(text, out, false);
    } else if (const char* path = "Metadata/project_settings.config"; zip.has(path)) {
        const std::string text = zip.read(path);
        out.settings = of_json(text);
        out.slicer = writer_of(text, out, true);
    }
    return out;
}

SlicerFile of_text(const std::string& text, const std::string& file) {
    SlicerFile out;
    const auto first = text.find_first_not_of(" \t\r\n");
    const bool json = first != std::string::npos && text[first] == '{';
    if (json) {
        out.settings = of_json(text);
    } else {
        out.settings = of_lines(text, Lines::plain);
        if (is_program(text, file)) out.settings = of_lines(config_block(text), Lines::commented);
    }
    out.slicer = writer_of(text, out, json);
    return out;
}

std::string whole(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::string text;
    if (in) text.assign(std::istreambuf_iterator<char>(in), {});
    if (!in || in.bad()) throw Error(Exit::io, "cannot read '" + file + "': " + std::strerror(errno));
    return text;
}

} // namespace

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
    case Slicer::unknown:
        break;
    }
    return "a slicer that the file does not name";
}

SlicerFile slicer_file(const std::string& file) {
    const std::string text = whole(file);
    if (text.starts_with("GCDE"))
        throw Error(Exit::bad_input, "cannot use '" + file +
                                         "': it is binary G-code; save it as plain G-code in its slicer, or export the "
                                         "configuration");
    SlicerFile out = archive::Zip::begins(text) ? of_project(text, file) : of_text(text, file);
    if (!out.settings.empty()) return out;
    throw Error(Exit::bad_input, "cannot use '" + file +
                                     "': it holds no settings of a slicer; export them as an .ini file (lines 'name = "
                                     "value'), or name a project of PrusaSlicer, OrcaSlicer or Bambu Studio (.3mf), or "
                                     "a G-code file of theirs");
}

ProjectBodies project_bodies(const std::string& file) {
    ProjectBodies out;
    try {
        const mesh::Bytes bytes = mesh::load(file);
        if (!archive::Zip::begins(bytes.view())) return out;
        using What = mesh::Body::What;
        for (const mesh::Body& b : mesh::read(bytes.view(), mesh::spoken_name(file)).bodies) {
            out.modifiers = out.modifiers || b.what == What::modifier;
            out.wanted = out.wanted || b.what == What::enforcer || b.what == What::painted;
            out.unwanted = out.unwanted || b.what == What::blocker || b.what == What::painted_blocker;
        }
    } catch (const Error&) { // settings only
    }
    return out;
}

} // namespace filum::app::filum
