// Beads that cannot fit the part, told before any work.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"

namespace filum::regions {

// Takes a layer into `box`, that of the part so far.  Throws Error: usage if the layer is higher than a bead is wide (a
// bead is laid flat, or it does not touch what is below); bad_input if its beads would take more memory than machines
// have.
void check_layer(const polygon::Layer& layer, double bead_width, geom::Box2& box);

// When all layers are known.  Throws Error(usage) if a bead is wider than the part is long and wide; notes a part that
// is narrower than a bead.
void check_part(const geom::Box2& box, double bead_width, Notes& notes);

} // namespace filum::regions
