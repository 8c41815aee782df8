// Rings that belong to the stroke inside them.
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill::scaffold {

// Lays `rings` rings along every loop of the region, the first half a bead inside, one bead apart, joins those that run
// side by side, and splices each group into the open curve next to it: curve and ring both give up a window one bead
// wide where they face each other, and two links join them, crossing nothing.  A group that finds no such place is
// added as a closed curve, with the note "ring not joined".
void splice_rings(const polygon::Loops& region, double bead_width, int rings, std::vector<toolpath::Curve>& curves,
                  Notes& notes);

} // namespace filum::fill::scaffold
