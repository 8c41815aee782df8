// Reads the metadata of slicers' 3MF projects: plates, and bodies that are not printed, such as modifiers.
#pragma once

#include "mesh/read.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace filum::mesh {

// A plate of a project and the build items on it. An item is an object's id and the index of the instance of that
// object, from 0.
struct Plate {
    std::string name;
    std::vector<std::pair<std::string, int>> items;
};

// The bodies of a project that are not printed: modifiers, support enforcers and blockers, negative bodies. Bodies are
// numbered in the order in which the project names them.
struct Project {
    struct Range {
        std::size_t first = 0, last = 0; // triangles
        std::size_t body = 0;
    };
    bool found = false;                                  // the file is a project of a slicer
    std::vector<Plate> plates;                           // empty: everything is on one plate
    std::vector<Body> bodies;                            // their meshes are still empty
    std::map<std::string, std::vector<Range>> triangles; // ranges of an object's mesh, by the object's id
    std::map<std::pair<std::string, std::string>, std::size_t> components; // bodies, by the ids of object and part

    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    // The body of triangle `i` of the object, or kNone.
    [[nodiscard]] std::size_t of_triangle(const std::string& object, std::size_t i) const;
    // The body of an object's component, or kNone.
    [[nodiscard]] std::size_t of_component(const std::string& object, const std::string& component) const;

    // Extruders, numbered from 0, of objects and of their parts. A part is a range of triangles or a component.
    std::map<std::string, std::uint32_t> extruder;
    std::map<std::string, std::vector<Range>> extruders; // `body` is the number of the extruder
    std::map<std::pair<std::string, std::string>, std::uint32_t> component_extruder;
};

// The kind of body that PrusaSlicer calls `word`, such as "SupportBlocker"; none for a part that is printed.
std::optional<Body::What> prusa_body(std::string_view word);

// Whether a key in the metadata of a body is the name of a setting.
bool is_setting(std::string_view key);

// Reads Metadata/Slic3r_PE_model.config of PrusaSlicer and SuperSlicer into `to`. Returns false if `text` is not XML.
bool read_prusa_project(const std::string& text, Project& to);

// Reads Metadata/model_settings.config of Bambu Studio and OrcaSlicer into `to`. Returns false if `text` is not XML.
bool read_bambu_project(const std::string& text, Project& to);

} // namespace filum::mesh
