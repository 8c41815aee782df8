// Lines as sources: from a text file, or where another mesh meets the surface.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "geodesic/sources.hpp"

#include <string>
#include <string_view>

namespace filum::geodesic {

// Lines of points in `text`: three numbers per row, separated by blanks or commas. An empty row starts the next line;
// '#' starts a comment. `name` is for messages.
// Throws Error(bad_input) that names the row in error, or if there is no point.
std::vector<std::vector<Vec3>> read_lines(std::string_view text, const std::string& name);

// Projects the lines onto the surface and adds them as sources; with a note if a point is farther from it than a mean
// edge.
// Throws Error(bad_input) as surface::trace does.
void add_lines(Sources& sources, const Surface& surface, const std::vector<std::vector<Vec3>>& lines, Notes& notes);

// Adds the intersection of the surface with the mesh (surface::meet). Returns the facts "source-mesh-crossing",
// "source-mesh-touching" and "source-mesh-flush", the amount of each kind of contact.
// Throws Error(usage) if they do not meet.
Facts add_mesh(Sources& sources, const Surface& surface, const mesh::Mesh& mesh);

} // namespace filum::geodesic
