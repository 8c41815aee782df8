// Remeshes a surface with triangles as large as its curvature and its use allow.
#pragma once

#include "surface/curve/locate.hpp"

namespace filum::surface::fit {

struct Options {
    double longest = 1;      // mm: longest sides, where the surface is flat
    double tolerance = 0.02; // mm: largest distance of chords from the surface
};

struct FittedSurface {
    Surface surface;
    double off = -1; // mm: greatest distance between the two surfaces, measured at corners, in middles of triangles,
                     // and on sides at places an eighth of a mean side apart; -1: not measured
    Vec3 off_at;
    std::size_t splits = 0; // sides that were halved on the way: the work
    std::size_t most_splits = 0;
};

// The work is bounded by construction. Let T be the number of triangles that the sizes ask for, about 2.3 area / h^2 at
// sides of h. A pass halves at most kMostWork T sides. There are three passes, three for each of two corrections, and
// if triangles are long and thin, one for each halving of the longest side L down to its size: log2(L / h), rounded up.
// A pass takes n log n for the n triangles that are there, and what it did not halve is in `off`.
inline constexpr double kMostWork = 10;

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

// The same for a surface with a locator, without measuring `off`.
FittedSurface fitted(const Surface& s, const curve::Locator& locator, const Options& o);

// The same in one pass without checking the distance: its time is proportional to the number of triangles of both
// surfaces, however long and thin the given ones are.
Surface evened(const Surface& s, const Options& o);

} // namespace filum::surface::fit
