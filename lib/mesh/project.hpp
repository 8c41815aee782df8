// What projects of slicers, beside the models of their 3MF, say of bodies that are not to be made.
#pragma once

#include "mesh/read.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace filum::mesh {

// A plate of a project: the items of the build that are on it, each by its object and by which of the items of that
// object it is, from 0.
struct Plate {
    std::string name;
    std::vector<std::pair<std::string, int>> items;
};

// Where the bodies of a project are, which say where settings hold, where supports are wanted or not, or what is to be
// cut away.  They are numbered in the order in which the project names them.
struct Project {
    struct Range {
        std::size_t first = 0, last = 0; // triangles
        std::size_t body = 0;
    };
    bool found = false;                                                    // the file is a project of a slicer
    std::vector<Plate> plates;                                             // none: everything is on one
    std::vector<Body> bodies;                                              // without meshes
    std::map<std::string, std::vector<Range>> triangles;                   // of the mesh of an object, by its id
    std::map<std::pair<std::string, std::string>, std::size_t> components; // the body, by the ids of object and part

    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    // The body that triangle `i` of the object is of, or kNone.
    [[nodiscard]] std::size_t of_triangle(const std::string& object, std::size_t i) const;
    // The body that a component of an object is, or kNone.
    [[nodiscard]] std::size_t of_component(const std::string& object, const std::string& component) const;
};

// Adds what Metadata/Slic3r_PE_model.config of PrusaSlicer and SuperSlicer says.  False if `text` is no XML.
bool read_prusa_project(const std::string& text, Project& to);

// Adds what Metadata/model_settings.config of Bambu Studio and OrcaSlicer says.  False if `text` is no XML.
bool read_bambu_project(const std::string& text, Project& to);

} // namespace filum::mesh
