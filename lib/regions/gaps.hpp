// Gaps too narrow to stay open.
#pragma once

#include "polygon/loops.hpp"

namespace filum::regions {

// Patches over every gap narrower than `width` mm between two stretches of the outlines that face each other across
// it, counter-clockwise, to be united with `loops` (simple, solid on the left); none where nothing is that near.
// Where edge e comes nearer than `width` to edge f, the patch is the convex hull of what of e is so near to f and of f
// to e; so two corners that all but touch get a neck, and a slit is filled along its length.  Two stretches of one
// outline count only if the way between them along it is longer than the circle of that diameter is round: a shorter
// one holds no room in which such a circle fits.  The result depends on the shape, not on where its points are.
polygon::Loops bridges(const polygon::Loops& loops, double width);

} // namespace filum::regions
