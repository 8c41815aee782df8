// Checks the size of parts before any work is done.
#pragma once

#include "app/slice/slice.hpp"
#include "base/note.hpp"
#include "geom/vec.hpp"
#include "machine/profile.hpp"
#include "mesh/place.hpp"

#include <string>

namespace filum::app::slice {

// Adds a note for a part that is so small or so large that the unit of its file is probably wrong.  `unit_known`: the
// file states the unit or the caller chose it; then the limit for small parts is 1 mm instead of 4 mm.
void check_size(const mesh::Box3& box, bool unit_known, Notes& notes);

// Adds a note if rounding can have changed the volume of a part by more than 2 %.  That happens if a file has
// coordinates in single precision, far from the origin.  `mesh`: as in the file, before it is placed.
void check_precision(const mesh::Mesh& mesh, Notes& notes);

// The profile that the options name; marlin's if they name none.
machine::Profile machine_of(const Options& o);

// Throws Error(bad_input) if the part is larger than the bed of the machine, or higher than its reach. Nothing is
// checked if the options say nothing about a machine. Machines that turn the part or the head are not checked, since
// their reach depends on the path.
void check_bed(const mesh::Box3& box, const Options& o);

// The size as text, such as "40.0 x 26.5 mm".
std::string size_text(geom::Vec2 size);

} // namespace filum::app::slice
