// Checks, before any work, that beads fit the part.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"

namespace filum::regions {

// Adds a layer to `box`, the bounds of the part so far. Throws Error(usage) if the layer is higher than a bead is wide:
// a bead is laid flat, or it does not touch the layer below. Throws Error(bad_input) if the layer's beads would take
// more memory than machines have.
void check_layer(const polygon::Layer& layer, double bead_width, geom::Box2& box);

// Checks the whole part. Throws Error(usage) if a bead is wider than the part is long and wide. Adds a note if the part
// is narrower than a bead.
void check_part(const geom::Box2& box, double bead_width, Notes& notes);

} // namespace filum::regions
