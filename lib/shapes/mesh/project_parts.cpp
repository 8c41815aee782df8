// Which settings of a project's objects and parts hold for the whole job, and which make bodies.
#include "base/error.hpp"
#include "mesh/project.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace filum::mesh {

namespace {

constexpr std::string_view kSupports[] = {"support_material", "enable_support"};

bool is_on(const std::string& value) { return value == "1" || value == "true"; }
bool of_supports(const std::string& key) { return std::ranges::find(kSupports, key) != std::end(kSupports); }

const std::string* value_of(const SlicerSettings& settings, const std::string& key) {
    const auto at = std::ranges::find(settings, key, &SlicerSettings::value_type::first);
    return at == settings.end() ? nullptr : &at->second;
}

void erase(SlicerSettings& settings, const std::string& key) {
    std::erase_if(settings, [&](const auto& s) { return s.first == key; });
}

// The value of a setting in the text of a project's configuration: lines "; key = value" of PrusaSlicer, or a JSON
// object of texts and lists of texts. "" if it has none.
std::string value_in(std::string_view text, const std::string& key) {
    const auto between = [&](const std::string& before, const char* after) -> std::string {
        const auto at = text.find(before);
        if (at == std::string_view::npos) return "";
        const auto from = text.find_first_not_of(" \t\n[\"", at + before.size());
        if (from == std::string_view::npos) return "";
        return std::string(text.substr(from, std::min(text.find_first_of(after, from), text.size()) - from));
    };
    const std::string line = between("\n; " + key + " =", "\r\n");
    return line.empty() ? between("\"" + key + "\":", "\"]\n") : line;
}

} // namespace

bool wants_supports(const Body& body, bool wanted) {
    using Purpose = Body::Purpose;
    if (body.what == (wanted ? Purpose::enforcer : Purpose::blocker)) return true;
    return body.printed && std::ranges::any_of(body.settings, [&](const auto& s) {
               return of_supports(s.first) && is_on(s.second) == wanted;
           });
}

bool changes_settings(const Body& body) {
    return body.what == Body::Purpose::modifier &&
           (!body.printed || !std::ranges::all_of(body.settings, of_supports, &SlicerSettings::value_type::first));
}

namespace {

// Moves a setting that all parts have to `shared`, and removes it where it is as usual. Supports: see
// divide_settings().
void divide(const std::string& key, const std::string& usual, const std::vector<Project::Part*>& parts,
            SlicerSettings& shared) {
    std::vector<std::string> values; // in effect, per part
    for (const Project::Part* part : parts) {
        const std::string* value = value_of(part->settings, key);
        values.push_back(value != nullptr ? *value : usual);
    }
    const bool same = std::ranges::all_of(values, [&](const std::string& v) { return v == values.front(); });
    const bool supports = !same && of_supports(key);
    if (supports) shared.emplace_back(key, "1");
    if (same && values.front() != usual) shared.emplace_back(key, values.front());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (same || supports || values[i] == usual) erase(parts[i]->settings, key);
        if (supports && !is_on(values[i])) parts[i]->settings.emplace_back(key, "0");
    }
}

} // namespace

void Project::divide_settings(int plate, const std::function<std::string(const std::string&)>& usual) {
    const auto on_plate = [&](const Part& part) {
        return plates.empty() || std::ranges::any_of(plates, [&](const Plate& p) {
                   return p.number == plate &&
                          std::ranges::any_of(p.items, [&](const auto& item) { return item.first == part.object; });
               });
    };
    std::vector<Part*> here;
    std::set<std::string> keys;
    for (Part& part : parts) {
        if (!on_plate(part)) continue;
        here.push_back(&part);
        for (const auto& setting : part.settings) keys.insert(setting.first);
    }
    for (const std::string& key : keys) divide(key, usual(key), here, shared);
    std::map<std::pair<std::string, SlicerSettings>, std::size_t>
        made; // bodies of an object's parts with equal settings
    for (const Part* part : here) {
        if (part->settings.empty()) continue;
        const auto [at, fresh] = made.try_emplace({part->object, part->settings}, bodies.size());
        if (fresh) {
            bodies.push_back({Body::Purpose::modifier, part->settings});
            bodies.back().printed = true;
        }
        // An object that holds its mesh itself has one part, with the object's own id.
        if (part->component.empty() || part->component == part->object)
            triangles[part->object].push_back({part->first, part->last, at->second});
        else
            components.at(part->object)[part->index].body = at->second;
    }
}

Project read_project(archive::Zip& zip, const std::string& name, int plate) {
    constexpr std::pair<const char*, bool (*)(const std::string&, Project&)> kFiles[] = {
        {"Metadata/Slic3r_PE_model.config", read_prusa_project},
        {"Metadata/model_settings.config", read_bambu_project}};
    Project out;
    for (const auto& [path, read] : kFiles) {
        out.found = out.found || zip.has(path);
        if (zip.has(path) && !read(zip.read(path), out))
            throw Error(Exit::bad_input,
                        "cannot read " + name + ": '" + std::string(path) + "' in the archive is no XML");
    }
    std::string config;
    for (const char* path : {"Metadata/Slic3r_PE.config", "Metadata/project_settings.config"}) {
        out.found = out.found || zip.has(path);
        if (zip.has(path) && !out.parts.empty()) config += "\n" + zip.read(path);
    }
    out.divide_settings(plate, [&](const std::string& key) { return value_in(config, key); });
    return out;
}

} // namespace filum::mesh
