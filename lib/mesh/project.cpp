#include "mesh/project.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <string_view>

namespace filum::mesh {

namespace {

constexpr std::string_view kPrusa[] = {"ParameterModifier", "SupportEnforcer", "SupportBlocker", "NegativeVolume"};
constexpr std::string_view kBambu[] = {"modifier_part", "support_enforcer", "support_blocker", "negative_part"};

template <std::size_t N>
bool one_of(const std::string_view (&words)[N], std::string_view word) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

} // namespace

bool NotMade::holds(const std::string& object, std::size_t i) const {
    const auto found = triangles.find(object);
    return found != triangles.end() &&
           std::ranges::any_of(found->second, [&](const Range& r) { return r.first <= i && i <= r.second; });
}

bool read_prusa_project(const std::string& text, NotMade& to) {
    pugi::xml_document xml;
    if (!xml.load_buffer(text.data(), text.size())) return false;
    for (const auto& object : xml.child("config").children("object"))
        for (const auto& volume : object.children("volume"))
            for (const auto& data : volume.children("metadata"))
                if (std::string_view(data.attribute("key").value()) == "volume_type" &&
                    one_of(kPrusa, data.attribute("value").value()))
                    to.triangles[object.attribute("id").value()].emplace_back(volume.attribute("firstid").as_ullong(),
                                                                              volume.attribute("lastid").as_ullong());
    return true;
}

bool read_bambu_project(const std::string& text, NotMade& to) {
    pugi::xml_document xml;
    if (!xml.load_buffer(text.data(), text.size())) return false;
    for (const auto& object : xml.child("config").children("object"))
        for (const auto& part : object.children("part"))
            if (one_of(kBambu, part.attribute("subtype").value()))
                to.components.emplace(object.attribute("id").value(), part.attribute("id").value());
    return true;
}

} // namespace filum::mesh
