// Lines as sources, from a text file or by another mesh.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "geodesic/sources.hpp"

#include <string>
#include <string_view>

namespace filum::geodesic {

// Lines of points in `text`: three numbers a line, between blanks or commas; an empty line begins the next one, '#' a
// comment.  `name` is for messages.  Throws Error(bad_input) naming the line of text that is none of these, or if there
// is no point at all.
std::vector<std::vector<Vec3>> read_lines(std::string_view text, const std::string& name);

// Adds them as sources, drawn onto the surface; noted if a point was farther from it than a mean edge.
// Throws Error(bad_input) as surface::trace does.
void add_lines(Sources& sources, const Surface& surface, const std::vector<std::vector<Vec3>>& lines, Notes& notes);

// Adds what the surface has in common with the mesh (surface::meet).  Returns how much of it there is of each kind as
// facts: "source-mesh-crossing", "source-mesh-touching", "source-mesh-flush".
// Throws Error(usage) if they do not meet.
Facts add_mesh(Sources& sources, const Surface& surface, const mesh::Mesh& mesh);

} // namespace filum::geodesic
