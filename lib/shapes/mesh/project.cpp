#include "mesh/project.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

namespace filum::mesh {

namespace {

using What = Body::What;

struct Word {
    std::string_view text;
    What what;
};
constexpr Word kPrusa[] = {{"ParameterModifier", What::modifier},
                           {"SupportEnforcer", What::enforcer},
                           {"SupportBlocker", What::blocker},
                           {"NegativeVolume", What::negative}};
constexpr Word kBambu[] = {{"modifier_part", What::modifier},
                           {"support_enforcer", What::enforcer},
                           {"support_blocker", What::blocker},
                           {"negative_part", What::negative}};
// Metadata of a body that are not settings.
constexpr std::string_view kNoSetting[] = {"name", "volume_type", "modifier", "matrix"};

template <std::size_t N>
std::optional<What> what_of(const Word (&words)[N], std::string_view text) {
    const auto found = std::ranges::find(words, text, &Word::text);
    return found == std::end(words) ? std::nullopt : std::optional(found->what);
}

} // namespace

std::optional<What> prusa_body(std::string_view word) { return what_of(kPrusa, word); }

bool is_setting(std::string_view key) {
    return !key.empty() && !key.starts_with("source_") && std::ranges::find(kNoSetting, key) == std::end(kNoSetting);
}

namespace {

// Makes a body with the settings in the metadata of an element.
Body body_of(What what, const pugi::xml_node& element) {
    Body out;
    out.what = what;
    for (const auto& data : element.children("metadata")) {
        const std::string key = data.attribute("key").value();
        if (!is_setting(key)) continue;
        out.settings.emplace_back(key, data.attribute("value").value());
    }
    return out;
}

// The value of an element's metadata with this name, or "".
std::string metadata(const pugi::xml_node& element, const char* key) {
    return element.find_child_by_attribute("metadata", "key", key).attribute("value").value();
}

Plate plate_of(const pugi::xml_node& element) {
    Plate out{metadata(element, "plater_name"), {}};
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

std::size_t Project::of_component(const std::string& object, const std::string& component) const {
    const auto found = components.find({object, component});
    return found == components.end() ? kNone : found->second;
}

bool read_prusa_project(const std::string& text, Project& to) {
    pugi::xml_document xml;
    if (!xml.load_buffer(text.data(), text.size())) return false;
    for (const auto& object : xml.child("config").children("object")) {
        read_extruder(object, to);
        for (const auto& volume : object.children("volume")) {
            if (const auto number = extruder_of(volume))
                to.extruders[object.attribute("id").value()].push_back(
                    {volume.attribute("firstid").as_ullong(), volume.attribute("lastid").as_ullong(), *number});
            for (const auto& data : volume.children("metadata")) {
                if (std::string_view(data.attribute("key").value()) != "volume_type") continue;
                const auto what = what_of(kPrusa, data.attribute("value").value());
                if (!what) continue;
                to.triangles[object.attribute("id").value()].push_back({volume.attribute("firstid").as_ullong(),
                                                                        volume.attribute("lastid").as_ullong(),
                                                                        to.bodies.size()});
                to.bodies.push_back(body_of(*what, volume));
            }
        }
    }
    return true;
}

bool read_bambu_project(const std::string& text, Project& to) {
    pugi::xml_document xml;
    if (!xml.load_buffer(text.data(), text.size())) return false;
    for (const auto& object : xml.child("config").children("object")) {
        read_extruder(object, to);
        for (const auto& part : object.children("part")) {
            if (const auto number = extruder_of(part))
                to.component_extruder.emplace(std::pair(object.attribute("id").value(), part.attribute("id").value()),
                                              *number);
            const auto what = what_of(kBambu, part.attribute("subtype").value());
            if (!what) continue;
            to.components.try_emplace({object.attribute("id").value(), part.attribute("id").value()}, to.bodies.size());
            to.bodies.push_back(body_of(*what, part));
        }
    }
    for (const auto& plate : xml.child("config").children("plate")) to.plates.push_back(plate_of(plate));
    if (std::ranges::all_of(to.plates, [](const Plate& p) { return p.items.empty(); })) to.plates.clear();
    return true;
}

} // namespace filum::mesh
