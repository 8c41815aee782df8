#include "mesh/project.hpp"

#include "mesh/formats.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

namespace filum::mesh {

namespace {

using Purpose = Body::Purpose;

struct Word {
    std::string_view text;
    Purpose what;
};
constexpr Word kPrusa[] = {{"ParameterModifier", Purpose::modifier},
                           {"SupportEnforcer", Purpose::enforcer},
                           {"SupportBlocker", Purpose::blocker},
                           {"NegativeVolume", Purpose::negative}};
constexpr Word kBambu[] = {{"modifier_part", Purpose::modifier},
                           {"support_enforcer", Purpose::enforcer},
                           {"support_blocker", Purpose::blocker},
                           {"negative_part", Purpose::negative}};
// Metadata of a body that are not settings.
constexpr std::string_view kNoSetting[] = {"name", "volume_type", "modifier", "matrix", "extruder"};

template <std::size_t N>
std::optional<Purpose> what_of(const Word (&words)[N], std::string_view text) {
    const auto found = std::ranges::find(words, text, &Word::text);
    return found == std::end(words) ? std::nullopt : std::optional(found->what);
}

} // namespace

std::optional<Purpose> prusa_body(std::string_view word) { return what_of(kPrusa, word); }

bool is_setting(std::string_view key) {
    return !key.empty() && !key.starts_with("source_") && std::ranges::find(kNoSetting, key) == std::end(kNoSetting);
}

namespace {

// Adds the settings in the metadata of an element; they replace those of the same names.
void add_settings(const pugi::xml_node& element, SlicerSettings& to) {
    for (const auto& data : element.children("metadata")) {
        const std::string key = data.attribute("key").value();
        if (!is_setting(key)) continue;
        std::erase_if(to, [&](const auto& before) { return before.first == key; });
        to.emplace_back(key, data.attribute("value").value());
    }
}

// The value of an element's metadata with this name, or "".
std::string metadata(const pugi::xml_node& element, const char* key) {
    return element.find_child_by_attribute("metadata", "key", key).attribute("value").value();
}

// Reads a plate. `number` is that of a plate without one.
Plate plate_of(const pugi::xml_node& element, int number) {
    const int own = std::atoi(metadata(element, "plater_id").c_str());
    Plate out{own > 0 ? own : number, metadata(element, "plater_name"), {}};
    for (const auto& instance : element.children("model_instance"))
        out.items.emplace_back(metadata(instance, "object_id"), std::atoi(metadata(instance, "instance_id").c_str()));
    return out;
}

} // namespace

namespace {

// The extruder in the metadata of an element, from 0; none if there is none, or the one of the element above counts.
std::optional<std::uint32_t> extruder_of(const pugi::xml_node& element) {
    const int number = std::atoi(metadata(element, "extruder").c_str());
    return number > 0 ? std::optional(static_cast<std::uint32_t>(number - 1)) : std::nullopt;
}

// Makes a body with the settings in the metadata of an element. Its extruder is a setting if it is not the one of the
// object, which printed parts follow without any setting.
Body body_of(Purpose what, const pugi::xml_node& element, const pugi::xml_node& object) {
    Body out;
    out.what = what;
    add_settings(element, out.settings);
    if (const auto own = extruder_of(element); own && *own != extruder_of(object).value_or(0))
        out.settings.emplace_back("extruder", std::to_string(*own + 1));
    return out;
}

// Makes a printed part of an object, with the settings of both elements.
Project::Part printed_part(const pugi::xml_node& object, const pugi::xml_node& element) {
    Project::Part out{object.attribute("id").value(), ""};
    add_settings(object, out.settings);
    add_settings(element, out.settings);
    return out;
}

// Reads the extruder of an object.
void read_extruder(const pugi::xml_node& object, Project& to) {
    if (const auto number = extruder_of(object)) to.extruder[object.attribute("id").value()] = *number;
}

} // namespace

std::size_t Project::of_triangle(const std::string& object, std::size_t i) const {
    const auto found = triangles.find(object);
    if (found == triangles.end()) return kNone;
    const auto at = std::ranges::find_if(found->second, [&](const Range& r) { return r.first <= i && i <= r.last; });
    return at == found->second.end() ? kNone : at->body;
}

std::size_t Project::part_of_triangle(const std::string& object, std::size_t i, std::size_t hint) const {
    const auto holds = [&](const Part& p) {
        return p.object == object && p.component.empty() && p.first <= i && i <= p.last;
    };
    if (hint < parts.size() && holds(parts[hint])) return hint;
    const auto at = std::ranges::find_if(parts, holds);
    return at == parts.end() ? kNone : static_cast<std::size_t>(at - parts.begin());
}

const Project::Component* Project::component(const std::string& object, const std::string& id,
                                             std::size_t index) const {
    const auto found = components.find(object);
    if (found == components.end()) return nullptr;
    const auto& all = found->second;
    if (index < all.size() && all[index].id == id) return &all[index];
    const auto at = std::ranges::find(all, id, &Component::id);
    return at == all.end() ? nullptr : &*at;
}

namespace {

void read_volume(const pugi::xml_node& object, const pugi::xml_node& volume, Project& to) {
    const std::string id = object.attribute("id").value();
    const Project::Range range{volume.attribute("firstid").as_ullong(), volume.attribute("lastid").as_ullong(), 0};
    if (const auto number = extruder_of(volume)) to.extruders[id].push_back({range.first, range.last, *number});
    std::string kind = metadata(volume, "volume_type");
    if (kind.empty() && metadata(volume, "modifier") == "1") kind = "ParameterModifier"; // Slic3r, before 1.41
    if (const auto what = what_of(kPrusa, kind)) {
        to.triangles[id].push_back({range.first, range.last, to.bodies.size()});
        to.bodies.push_back(body_of(*what, volume, object));
    } else if (kind.empty() || kind == "ModelPart") {
        to.parts.push_back(printed_part(object, volume));
        to.parts.back().first = range.first;
        to.parts.back().last = range.last;
    }
}

void read_part(const pugi::xml_node& object, const pugi::xml_node& part, Project& to) {
    const std::string id = object.attribute("id").value(), component = part.attribute("id").value();
    auto& all = to.components[id];
    all.push_back({component, Project::kNone, extruder_of(part)});
    const std::string kind = part.attribute("subtype").value();
    if (const auto what = what_of(kBambu, kind)) {
        all.back().body = to.bodies.size();
        to.bodies.push_back(body_of(*what, part, object));
    } else if (kind.empty() || kind == "normal_part") {
        to.parts.push_back(printed_part(object, part));
        to.parts.back().component = component;
        to.parts.back().index = all.size() - 1;
    }
}

// Calls read(object, element, to) for each object's elements of this name; an object without any is one part.
template <typename Read>
void read_objects(const pugi::xml_node& config, const char* name, const Read& read, Project& to) {
    for (const auto& object : config.children("object")) {
        read_extruder(object, to);
        for (const auto& element : object.children(name)) read(object, element, to);
        if (!object.child(name)) to.parts.push_back(printed_part(object, {}));
    }
}

} // namespace

bool read_prusa_project(const std::string& text, Project& to) {
    pugi::xml_document xml;
    if (!xml.load_buffer(text.data(), text.size())) return false;
    read_objects(xml.child("config"), "volume", read_volume, to);
    return true;
}

bool read_bambu_project(const std::string& text, Project& to) {
    pugi::xml_document xml;
    if (!xml.load_buffer(text.data(), text.size())) return false;
    read_objects(xml.child("config"), "part", read_part, to);
    for (const auto& plate : xml.child("config").children("plate"))
        to.plates.push_back(plate_of(plate, static_cast<int>(to.plates.size()) + 1));
    std::ranges::stable_sort(to.plates, {}, &Plate::number);
    if (std::ranges::all_of(to.plates, [](const Plate& p) { return p.items.empty(); })) to.plates.clear();
    return true;
}

} // namespace filum::mesh
