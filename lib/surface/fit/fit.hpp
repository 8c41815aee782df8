// A surface in triangles that are as large as its shape and its use allow.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface::fit {

struct Options {
    double longest = 1;      // mm: sides, where the surface is flat
    double tolerance = 0.02; // mm: how far chords may be off the surface
};

struct Fitted {
    Surface surface;
    double off = 0; // mm: how far either is from the other where it is farthest: at corners, in middles of triangles,
                    // and on sides at places an eighth of a mean side apart
    Vec3 off_at;
};

// The surface in triangles that are alike in shape, whose vertices lie on it, with sides of `longest` mm where it is
// flat, at most a third longer, shorter where it bends, so that chords are off by about the tolerance at most, and
// growing gradually in between.  No triangle turns over against the surface.  Rims and edges sharper than 30 degrees
// stay, as chords within the tolerance; so do narrow places, whose rims may ask for shorter sides.  Sides get no
// shorter than given triangles are high where these bend, nor than 11.5 tolerances: what is left is `off`, told.  Where
// else chords are farther off, sides there are made shorter, twice at most.  How the surface was cut into triangles
// decides little.  The same for the same surface.  Throws Error(usage) if it would take more than 20 million triangles.
// (Splitting, collapsing, flipping, moving: Botsch, Kobbelt 2004; sizes by chords: Dunyach et al. 2013.)
Fitted fitted(const Surface& s, const Options& o);

// The same by one round, without a look at how far the surfaces are apart: in a time that goes with the triangles of
// both, however long and thin those given are.
Surface evened(const Surface& s, const Options& o);

} // namespace filum::surface::fit
