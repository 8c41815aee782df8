// One reader per file format; private to lib/shapes/mesh.  All of them throw the errors that mesh::read documents.
#pragma once

#include "mesh/read.hpp"

namespace filum::mesh {

// True if the bytes can be records of a binary STL: a whole number of them, with coordinates of usual sizes,
// not all 0.
bool are_stl_records(std::string_view bytes);

// Both return welded vertices.
Mesh read_stl_binary(std::string_view bytes, const std::string& name, Notes& notes);
Mesh read_stl_ascii(std::string_view bytes, const std::string& name, Notes& notes);

// These return the vertices of the file, unwelded; every index is in range.
Mesh read_obj(std::string_view bytes, const std::string& name, Notes& notes);
Mesh read_ply(std::string_view bytes, const std::string& name, Notes& notes);
Mesh read_off(std::string_view bytes, const std::string& name, Notes& notes);

// Fills all of `to` except `kind`; coordinates are in mm. Of a slicer's project it reads plate number `plate`, counted
// from 1.
void read_3mf(std::string_view bytes, const std::string& name, int plate, File& to);

// The same for AMF, unpacked.
void read_amf(std::string_view bytes, const std::string& name, File& to);

// Limits of what a file with copies of objects may ask for.
inline constexpr std::size_t kMaxTriangles = std::size_t{1} << 24; // with all copies
inline constexpr std::size_t kMaxCopies = 100000;
inline constexpr int kMaxDepth = 32; // of objects within objects

// Recognises formats that no reader takes, for error messages. Returns the format and the advice: "a GLB file (binary
// glTF); export it as STL". Returns "" if the format is unknown.
std::string foreign(std::string_view bytes);

// True if the ending of the name is that of a mesh format.
bool is_mesh_name(std::string_view name);

// The OFF keyword at the start of `text`, or "" if there is none. A blank, a line end or a number must follow it.
std::string_view off_keyword(std::string_view text);

// Makes a note of this library.  The command adds the name of the stage.
inline Note note(NoteCode code, double amount = 0, std::string detail = {}) {
    return {.code = code, .amount = amount, .detail = std::move(detail)};
}

// Adds a note of that many cases, if there are any.
inline void tell(NoteCode code, std::size_t count, Notes& notes) {
    if (count == 0) return;
    notes.push_back(note(code));
    notes.back().count = count;
}

} // namespace filum::mesh
