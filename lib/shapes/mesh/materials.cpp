#include "mesh/materials.hpp"

#include "mesh/threemf_rules.hpp"

#include <algorithm>
#include <pugixml.hpp>

namespace filum::mesh {

namespace {

constexpr std::uint32_t kMostMaterials = 1000; // a tool has at most this number

} // namespace

void Materials::add_groups(const std::string& path, const pugi::xml_node& resources) {
    for (const auto& group : resources.children()) {
        const std::string_view name = threemf::local_name(group);
        if (name != "basematerials" && name != "colorgroup" && name != "compositematerials") continue;
        first_.emplace(std::pair(path, std::string(group.attribute("id").value())), count_);
        count_ += static_cast<std::uint32_t>(std::distance(group.begin(), group.end()));
    }
}

std::uint32_t Materials::property(const std::string& path, const char* group, unsigned index,
                                  std::uint32_t otherwise) const {
    const auto found = first_.find({path, group});
    return found == first_.end() ? otherwise
                                 : std::min(found->second + std::min(index, kMostMaterials), kMostMaterials);
}

Materials::Material Materials::of(const std::string& path, const pugi::xml_node& object, bool item,
                                  const Project::Component* component, const Material& above,
                                  const Project& project) const {
    const std::string id = object.attribute("id").value();
    Material out = above;
    out.object = item ? id : "";
    if (!above.by_project)
        out.number =
            property(path, object.attribute("pid").value(), object.attribute("pindex").as_uint(), above.number);
    const auto set = [&](std::uint32_t number) {
        out.number = std::min(number, kMostMaterials);
        out.by_project = true;
    };
    if (const auto own = project.extruder.find(id); item && own != project.extruder.end()) set(own->second);
    if (component != nullptr && component->extruder) set(*component->extruder);
    return out;
}

std::uint32_t Materials::of_triangle(const std::string& path, const pugi::xml_node& triangle, std::size_t i,
                                     const Material& mesh, const Project& project) const {
    if (const auto ranges = project.extruders.find(mesh.object); ranges != project.extruders.end())
        for (const Project::Range& r : ranges->second)
            if (r.first <= i && i <= r.last) return std::min(static_cast<std::uint32_t>(r.body), kMostMaterials);
    if (mesh.by_project) return mesh.number;
    const auto group = triangle.attribute("pid");
    return group ? property(path, group.value(), triangle.attribute("p1").as_uint(), mesh.number) : mesh.number;
}

void keep_if_several(std::vector<std::uint32_t>& materials) {
    if (std::ranges::all_of(materials, [&](std::uint32_t m) { return m == materials.front(); })) materials.clear();
}

} // namespace filum::mesh
