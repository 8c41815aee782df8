// Remeshes a surface with triangles as large as its curvature and its use allow.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface::fit {

struct Options {
    double longest = 1;      // mm: longest sides, where the surface is flat
    double tolerance = 0.02; // mm: largest distance of chords from the surface
};

struct FittedSurface {
    Surface surface;
    double off = 0; // mm: greatest distance between the two surfaces, measured at corners, in middles of triangles, and
                    // on sides at places an eighth of a mean side apart
    Vec3 off_at;
};

// The surface with well-shaped triangles and vertices on it. Sides are `longest` mm where it is flat (at most a third
// longer), shorter where it is curved, so that chords deviate by about the tolerance at most, and change gradually in
// between. No triangle is turned over. Rims and edges sharper than 30 degrees are kept as chords within the tolerance;
// so are narrow parts, whose rims may need shorter sides.
// Sides are at least as long as given triangles at curved places are high, and at least 11.5 tolerances; the deviation
// that remains is `off`. Elsewhere sides are shortened where chords deviate too much, at most twice. The result
// depends little on the given triangles, and is the same for the same surface.
// Throws Error(usage) if it would take more than 20 million triangles. (Splitting, collapsing, flipping, moving:
// Botsch, Kobbelt 2004; sizes by chords: Dunyach et al. 2013.)
FittedSurface fitted(const Surface& s, const Options& o);

// The same in one pass without checking the distance: its time is proportional to the number of triangles of both
// surfaces, however long and thin the given ones are.
Surface evened(const Surface& s, const Options& o);

} // namespace filum::surface::fit
