// One reader per file format; private to lib/mesh.  All throw Error as mesh::read says.
#pragma once

#include "mesh/read.hpp"

namespace filum::mesh {

// These two give welded vertices.
Mesh read_stl_binary(std::string_view bytes, const std::string& name, Notes& notes);
Mesh read_stl_ascii(std::string_view bytes, const std::string& name, Notes& notes);

// These give vertices as they stand in the file; indices are in range.
Mesh read_obj(std::string_view bytes, const std::string& name, Notes& notes);
Mesh read_ply(std::string_view bytes, const std::string& name, Notes& notes);
Mesh read_off(std::string_view bytes, const std::string& name, Notes& notes);

// Everything but the kind; in mm.  Of a slicer's project the plate of that number, from 1.
void read_3mf(std::string_view bytes, const std::string& name, int plate, File& to);

// What `bytes` are, as far as anyone can tell, with what to do: "a GLB file (binary glTF); export it as STL".  "" if
// nobody can.  For messages about files that no reader takes.
std::string foreign(std::string_view bytes);

// True if a file of that name would be a mesh.
bool is_mesh_name(std::string_view name);

// The keyword of an OFF file that `text` begins with, "" if there is none; a blank, a line end or a number follows it.
std::string_view off_keyword(std::string_view text);

// A note of this library; the stage's name is set by the command.
inline Note note(NoteCode code, double amount = 0, std::string detail = {}) {
    return {.code = code, .amount = amount, .detail = std::move(detail)};
}

} // namespace filum::mesh
