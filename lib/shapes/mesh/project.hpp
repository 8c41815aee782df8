// Reads the metadata of slicers' 3MF projects: plates, bodies that are not printed, such as modifiers, and settings of
// objects and of their parts.
#pragma once

#include "archive/zip.hpp"
#include "mesh/read.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace filum::mesh {

// A plate of a project and the build items on it. An item is an object's id and the index of the instance of that
// object, from 0.
struct Plate {
    int number = 1; // from 1, as the slicer shows it
    std::string name;
    std::vector<std::pair<std::string, int>> items;
};

// Names and values of settings, in the slicer's own terms.
using SlicerSettings = std::vector<std::pair<std::string, std::string>>;

// The bodies of a project: modifiers, support enforcers and blockers, negative bodies. They are not printed. After them
// come parts that are printed with settings of their own (Body::printed).
struct Project {
    struct Range {
        std::size_t first = 0, last = 0; // triangles
        std::size_t body = 0;
    };
    bool found = false;                                  // the file is a project of a slicer
    std::vector<Plate> plates;                           // by number; empty: everything is on one plate
    std::vector<Body> bodies;                            // their meshes are still empty
    std::map<std::string, std::vector<Range>> triangles; // ranges of an object's mesh, by the object's id

    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    // The properties of a component of an object.
    struct Component {
        std::string id;                          // of the object that it is
        std::size_t body = kNone;                // it belongs to
        std::optional<std::uint32_t> extruder{}; // from 0
    };
    std::map<std::string, std::vector<Component>> components; // by the object's id, in the order of the file
    // The body of triangle `i` of the object, or kNone.
    [[nodiscard]] std::size_t of_triangle(const std::string& object, std::size_t i) const;
    // The entry for component number `index` of an object, which is the object `id`: the entry of that number if it
    // has the id, otherwise the first one with it, as in OrcaSlicer, since several parts may share one mesh. Null if
    // none.
    [[nodiscard]] const Component* component(const std::string& object, const std::string& id, std::size_t index) const;
    // Whether the triangles of a body, or those of no body (kNone), are printed.
    [[nodiscard]] bool printed(std::size_t body) const { return body == kNone || bodies[body].printed; }

    // Extruders, numbered from 0, of objects and of their ranges of triangles.
    std::map<std::string, std::uint32_t> extruder;
    std::map<std::string, std::vector<Range>> extruders; // `body` is the number of the extruder

    // A printed part of an object with the settings of both; those of the part win.
    struct Part {
        std::string object, component;       // `component` is empty for a range of triangles
        std::size_t first = 0, last = kNone; // triangles
        std::size_t index = 0;               // of the component
        SlicerSettings settings{};
    };
    std::vector<Part> parts;
    // The part whose range holds triangle `i` of the object, or kNone; looks at `hint` first.
    [[nodiscard]] std::size_t part_of_triangle(const std::string& object, std::size_t i, std::size_t hint) const;
    SlicerSettings shared; // settings that all parts of the plate have; they hold for the whole job

    // Divides the settings of the parts on a plate: what all of them have goes to `shared`, and parts that differ in
    // other settings become bodies. `usual` is the project's own value of a setting, "" if it has none. If some parts
    // want supports and others do not, the job has supports, and the others are marked as without.
    void divide_settings(int plate, const std::function<std::string(const std::string&)>& usual);
};

// The kind of body that PrusaSlicer calls `word`, such as "SupportBlocker"; none for a part that is printed.
std::optional<Body::Purpose> prusa_body(std::string_view word);

// Whether a key in the metadata of a body is the name of a setting.
bool is_setting(std::string_view key);

// Reads all of it from an archive. `plate` counts from 1. Throws Error(bad_input) if metadata are no XML.
Project read_project(archive::Zip& zip, const std::string& name, int plate);

// Whether supports are wanted in a body, or not wanted (`wanted` is false): it is an enforcer or a blocker, or a
// printed part whose own settings say so.
bool wants_supports(const Body& body, bool wanted);

// Whether a body has settings other than those for supports.
bool changes_settings(const Body& body);

// Reads Metadata/Slic3r_PE_model.config of PrusaSlicer and SuperSlicer into `to`. Returns false if `text` is not XML.
bool read_prusa_project(const std::string& text, Project& to);

// Reads Metadata/model_settings.config of Bambu Studio and OrcaSlicer into `to`. Returns false if `text` is not XML.
bool read_bambu_project(const std::string& text, Project& to);

} // namespace filum::mesh
