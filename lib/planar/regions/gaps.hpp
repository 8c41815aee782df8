// Closes gaps that are too narrow to stay open.
#pragma once

#include "polygon/loops.hpp"

namespace filum::regions {

// Patches, counter-clockwise, over every gap narrower than `width` mm between two stretches of outline that face each
// other. They are to be united with `loops` (simple, solid on the left). Empty if nothing is that near. Where edge e
// comes nearer than `width` to edge f, the patch is the convex hull of their parts that are so near. Two corners that
// almost touch get a neck, and a slit is filled along its length. Two stretches of one outline count only if the way
// between them along it is longer than pi * `width`. A shorter way encloses no room for a circle of that diameter. The
// result depends on the shape, not on the places of its points.
polygon::Loops bridges(const polygon::Loops& loops, double width, int layer = -1);

// The greatest length of all gaps of a layer, measured along each patch, in diagonals of the layer's box. It limits the
// work where spikes lie side by side over the whole layer; long seams between parts of a large layer stay far below.
// With more, bridges() throws Error(bad_input) with the layer and a place.
inline constexpr double kMostGaps = 1000;

} // namespace filum::regions
