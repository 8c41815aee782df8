// Lines as sources, from a text file.
#pragma once

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

} // namespace filum::geodesic
