// What projects of slicers, beside the models of their 3MF, say of bodies that are not to be made.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace filum::mesh {

// Bodies that say where settings hold, where supports are wanted or not, or what is to be cut away.
struct NotMade {
    using Range = std::pair<std::size_t, std::size_t>;        // first and last
    std::map<std::string, std::vector<Range>> triangles;      // of the mesh of an object, by its id
    std::set<std::pair<std::string, std::string>> components; // of an object, by both ids

    // Whether triangle `i` of the object is of such a body.
    [[nodiscard]] bool holds(const std::string& object, std::size_t i) const;
};

// Adds what Metadata/Slic3r_PE_model.config of PrusaSlicer and SuperSlicer says.  False if `text` is no XML.
bool read_prusa_project(const std::string& text, NotMade& to);

// Adds what Metadata/model_settings.config of Bambu Studio and OrcaSlicer says.  False if `text` is no XML.
bool read_bambu_project(const std::string& text, NotMade& to);

} // namespace filum::mesh
