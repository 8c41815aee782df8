// Reading mesh files.
#pragma once

#include "mesh/mesh.hpp"

#include <string>
#include <string_view>

namespace filum::mesh {

// The mesh in `bytes`, the whole content of a file; its kind is recognised by content.  `name` is for messages.
// Throws Error(bad_input).
Mesh read(std::string_view bytes, const std::string& name);

} // namespace filum::mesh
