// Reading mesh files: STL (binary, ASCII), OBJ, PLY (ASCII, binary of either byte order), OFF, 3MF.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace filum::mesh {

enum class Kind : std::uint8_t { unknown, stl_binary, stl_ascii, obj, ply, off, threemf, step };

// The kind of file that `bytes` are, by content alone: a binary STL whose header begins with "solid" is known by its
// size, text by its first word.
Kind recognise(std::string_view bytes);

// Whether files of this kind say what unit they are in.
inline bool states_unit(Kind kind) { return kind == Kind::threemf || kind == Kind::step; }

// What a slicer's project holds beside what is to be made, in mm, where it puts that.
struct Body {
    enum class What : std::uint8_t {
        modifier,       // other settings hold in it
        enforcer,       // supports are wanted in it
        blocker,        // no supports are wanted in it
        negative,       // it is to be cut away
        painted,        // faces of the part under which supports are wanted: no solid
        painted_blocker // the same where none are
    };
    What what = What::modifier;
    std::vector<std::pair<std::string, std::string>> settings{}; // names and values as that slicer has them
    Mesh mesh{};
    std::uint32_t item =
        0; // the item of the build that the body belongs to; a negative body is cut away from it.  See File::items
};

struct File {
    Mesh mesh;
    Kind kind = Kind::unknown;
    Notes notes;                // what was left out
    std::vector<Body> bodies{}; // of a 3MF; what is painted comes last
    // The item of the build that each triangle of the mesh is of; only where bodies are negative.
    std::vector<std::uint32_t> items{};
};

// Notes that negative bodies are not cut away; for programs that need no solid.
void tell_uncut(const File& file, Notes& notes);

// The mesh in `bytes`, the whole content of a file; `name` is for messages, in quotes if it is a path.
// Vertices with the same coordinates are one; every coordinate is finite, every index in range, no triangle has two
// equal corners (those have no area and bind no others, so they go without a note).  Triangles with a corner that is
// no finite number are left out, with a note.  Of a slicer's project it reads plate `plate`, from 1.  Polygons are cut
// into triangles, whatever their shape (polygons.hpp).  Mesh::of_file tells which vertex is which of the file's (of an
// STL: of its corners, those in one place being one).  Coordinates are in the file's unit; of a 3MF,
// which states it, in mm. Throws Error: truncated if the file is empty or ends before what it announces, bad_input if
// it is of no known kind or STEP (mesh::step::read reads that), malformed, or holds no triangle.
File read(std::string_view bytes, const std::string& name, int plate = 1);

// A whole file in memory.
struct Bytes {
    std::unique_ptr<char[]> data;
    std::size_t size = 0;
    [[nodiscard]] std::string_view view() const { return {data.get(), size}; }
};

// The content of `path`, "-" for standard input; at most 4 GiB.  Throws Error(io), or bad_input if there is more.
Bytes load(const std::string& path);

// How messages name `path`: in quotes, or "standard input".
std::string spoken_name(const std::string& path);

} // namespace filum::mesh
