// The materials of a 3MF: which of its triangles are printed with which extruder. Private to lib/shapes/mesh.
#pragma once

#include "mesh/project.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pugi {
class xml_node;
}

namespace filum::mesh {

// Finds the material of each triangle. The extruder that a slicer's project names counts before the properties of the
// core specification (pid and pindex of the object, pid and p1 of the triangle). Base materials and other property
// groups are numbered in the order of the file, each with its entries.
class Materials {
  public:
    // Numbers the property groups of a model; `path` names its file.
    void add_groups(const std::string& path, const pugi::xml_node& resources);

    // What an object inherits and passes on to its components.
    struct Material {
        std::uint32_t number = 0;
        bool by_project = false; // an extruder of a project; it counts before properties of triangles
        std::string object{};    // the object of a project whose ranges of triangles count; "" if none
    };
    // The material of an object within `above`: of an item of the build, or of a component, for which `component` is
    // what the project says of it, if it does.
    [[nodiscard]] Material of(const std::string& path, const pugi::xml_node& object, bool item,
                              const Project::Component* component, const Material& above, const Project& project) const;
    // The material of triangle number `i` of a mesh.
    [[nodiscard]] std::uint32_t of_triangle(const std::string& path, const pugi::xml_node& triangle, std::size_t i,
                                            const Material& mesh, const Project& project) const;

  private:
    [[nodiscard]] std::uint32_t property(const std::string& path, const char* group, unsigned index,
                                         std::uint32_t otherwise) const;
    std::map<std::pair<std::string, std::string>, std::uint32_t> first_; // number of each group's first entry
    std::uint32_t count_ = 0;
};

// Clears `materials` if all of them are the same.
void keep_if_several(std::vector<std::uint32_t>& materials);

} // namespace filum::mesh
