// Reading mesh files: STL (binary, ASCII), OBJ, PLY (ASCII, binary of either byte order), OFF, 3MF, AMF.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace filum::mesh {

enum class Kind : std::uint8_t { unknown, stl_binary, stl_ascii, obj, ply, off, threemf, amf, step };

// The format of `bytes`, by content alone. A binary STL whose header begins with "solid" is recognised by its size, and
// a text format by its first word.
Kind recognise(std::string_view bytes);

// True if files of this kind state their unit.
inline bool states_unit(Kind kind) { return kind == Kind::threemf || kind == Kind::amf || kind == Kind::step; }

// A body of a slicer's project with a purpose or with settings of its own; in mm, at the position that the project
// gives it.
struct Body {
    enum class Purpose : std::uint8_t {
        modifier,        // region with other settings
        enforcer,        // supports are wanted inside it
        blocker,         // no supports are wanted inside it
        negative,        // cut away from the part
        painted,         // painted faces that want supports below; an open surface, not a solid
        painted_blocker, // painted faces that want no supports below
        painted_seam,    // painted faces on which strokes should begin
        painted_no_seam  // painted faces on which no stroke should begin
    };
    Purpose what = Purpose::modifier;
    std::vector<std::pair<std::string, std::string>> settings{}; // names and values in the slicer's own terms
    Mesh mesh{};
    std::uint32_t item = 0; // the build item of the body; a negative body is cut away from that item.  See File::items
    bool printed = false;   // it is a part that is printed, a modifier only because it has settings of its own
};

struct File {
    Mesh mesh;
    Kind kind = Kind::unknown;
    Notes notes;                // faults that were repaired, and parts that were left out
    std::vector<Body> bodies{}; // of a 3MF or AMF; painted faces come last
    // Per triangle of the mesh, the number of its material or extruder, from 0; of a 3MF or AMF. Empty if all have the
    // same.
    std::vector<std::uint32_t> materials{};
    // Per triangle of the mesh, its build item. Filled only if a body is negative.
    std::vector<std::uint32_t> items{};
};

// Adds a note that negative bodies are not cut away; for programs that need no solid.
void tell_uncut(const File& file, Notes& notes);

// Reads a mesh from `bytes`, the whole content of a file. `name` is for messages, in quotes if it is a path.
//
// Vertices with equal coordinates are merged. Every coordinate is finite and every index in range. Triangles with two
// equal corners are left out without a note, as they have no area. Triangles with a corner that is not finite are left
// out with a note. Polygons of any shape are cut into triangles (polygons.hpp). Mesh::of_file maps the vertices of the
// file to those of the mesh; vertices of an STL are its distinct corners.
//
// Coordinates are in the unit of the file; a 3MF or an AMF states its unit and is converted to mm. Of a slicer's
// project, plate number `plate` is read, counted from 1. Of a ZIP archive that is no 3MF, its one mesh is read.
//
// Throws Error: truncated if the file is empty or shorter than it announces; bad_input if its format is unknown or STEP
// (use mesh::step::read), if it is malformed, or if it holds no triangle.
File read(std::string_view bytes, const std::string& name, int plate = 1);

// A whole file in memory.
struct Bytes {
    std::unique_ptr<char[]> data;
    std::size_t size = 0;
    [[nodiscard]] std::string_view view() const { return {data.get(), size}; }
};

// Reads `path`, or standard input for "-"; at most 4 GiB. Throws Error(io), or Error(bad_input) if there is more.
Bytes load(const std::string& path);

// The name of `path` in messages: in quotes, or "standard input".
std::string spoken_name(const std::string& path);

} // namespace filum::mesh
