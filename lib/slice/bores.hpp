// Bores: holes that some layers close and others leave open, such as the bore of a ring with a window.
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"

#include <span>
#include <vector>

namespace filum::slice {

// For each layer, lowest first, the outlines of the bores that this layer leaves open.  A bore is open on a layer if a
// layer above or below has it as a hole, more of its walls goes on than a slot of its width would share with it, and no
// solid stands in it.  `contours`: the layers' outlines.
//
// Walls that go on while solid stands in the bore, as where a slanted bore meets a window, are not followed: a note
// says how many mm of wall `compensation` leaves as they are.
std::vector<polygon::Loops> open_bores(std::span<const polygon::Loops> contours, Notes& notes);

// `contours` with the walls of the layer's open bores moved outwards by `by` mm, or inwards if that is negative.
polygon::Loops with_wider_bores(const polygon::Loops& contours, const polygon::Loops& bores, double by);

} // namespace filum::slice
