// Parts of unlikely size, told before any work.
#pragma once

#include "base/note.hpp"
#include "geom/vec.hpp"
#include "mesh/place.hpp"

#include <string>

namespace filum::app::slice {

// Notes a part that is so small, or so large, that its file is likely to be in another unit than it was taken to be:
// `unit_known` if the file states it or the caller chose one.
void check_size(const mesh::Box3& box, bool unit_known, Notes& notes);

// Notes how much of its volume a part can have lost, or gained, because its file gives coordinates in single precision
// far from the origin, if that is more than 2 %.  `mesh` as the file gives it.
void check_precision(const mesh::Mesh& mesh, Notes& notes);

// Throws Error(bad_input) if the part is larger than the bed of the machine, or higher than that reaches; `machine` as
// machine::load_profile takes it.  Machines that turn the part or the head are not checked: what they reach
// depends on the path.
void check_bed(const mesh::Box3& box, const std::string& machine);

// "40.0 x 26.5 mm".
std::string size_text(geom::Vec2 size);

} // namespace filum::app::slice
