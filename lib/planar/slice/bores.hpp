// Bores: holes that some layers close and others leave open, such as the bore of a ring with a window.
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"

#include <span>
#include <vector>

namespace filum::slice {

// The outlines of the bores that each layer leaves open, lowest layer first. A bore is open on a layer under three
// conditions. A layer above or below has it as a hole. The layer continues more of its wall than a slot of its width
// would share with it. No solid stands in it. `contours` are the outlines of the layers.
//
// Tapered and slanted bores are followed, too: they change by the same amount from layer to layer. A wall is not
// followed where solid stands in the bore, and beyond a step that no other side of the window shows. A note reports how
// many mm of wall the compensation leaves unchanged.
std::vector<polygon::Loops> open_bores(std::span<const polygon::Loops> contours, Notes& notes);

// Moves the walls of the layer's open bores outwards by `by` mm, or inwards if it is negative. Returns the new
// contours.
polygon::Loops with_wider_bores(const polygon::Loops& contours, const polygon::Loops& bores, double by);

} // namespace filum::slice
