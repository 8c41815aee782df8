#include "app/filum/slicer_file.hpp"

#include "archive/zip.hpp"
#include "base/error.hpp"
#include "mesh/read.hpp"
#include "wire/json.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace filum::app::filum {

namespace {

std::string trimmed(const std::string& text) {
    const auto from = text.find_first_not_of(" \t\r");
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

// `commented`: as in projects of PrusaSlicer, where every line begins with a semicolon.
std::vector<SlicerSetting> of_lines(const std::string& text, bool commented) {
    std::vector<SlicerSetting> out;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        line = trimmed(line);
        if (commented && line.starts_with(';')) line = trimmed(line.substr(1));
        const auto equal = line.find('=');
        if (line.empty() || line[0] == '#' || line[0] == ';' || line[0] == '[' || equal == std::string::npos) continue;
        const std::string value = trimmed(line.substr(equal + 1));
        out.push_back({trimmed(line.substr(0, equal)), trimmed(value.substr(0, value.find_first_of(",;")))});
    }
    return out;
}

std::vector<SlicerSetting> of_json(const std::string& text) {
    std::vector<SlicerSetting> out;
    for (const auto& [key, value] : wire::json_values(text)) out.push_back({key, value});
    return out;
}

std::vector<SlicerSetting> of_project(const std::string& bytes, const std::string& file) {
    archive::Zip zip(bytes, "'" + file + "'");
    if (const char* path = "Metadata/Slic3r_PE.config"; zip.has(path)) return of_lines(zip.read(path), true);
    if (const char* path = "Metadata/project_settings.config"; zip.has(path)) return of_json(zip.read(path));
    return {};
}

} // namespace

std::vector<SlicerSetting> slicer_settings(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::string text;
    if (in) text.assign(std::istreambuf_iterator<char>(in), {});
    if (!in || in.bad()) throw Error(Exit::io, "cannot read '" + file + "': " + std::strerror(errno));
    const auto first = text.find_first_not_of(" \t\r\n");
    const bool json = first != std::string::npos && text[first] == '{';
    std::vector<SlicerSetting> out = archive::Zip::begins(text) ? of_project(text, file)
                                     : json                     ? of_json(text)
                                                                : of_lines(text, false);
    if (!out.empty()) return out;
    throw Error(Exit::bad_input, "cannot use '" + file +
                                     "': it holds no settings of a slicer; export them as an .ini file (lines 'name = "
                                     "value'), or name a project of PrusaSlicer, OrcaSlicer or Bambu Studio (.3mf)");
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
