// A surface that goes on beyond its rims, as a part does that is trimmed later.
#pragma once

#include "surface/lids.hpp"

namespace filum::surface {

struct Flanged {
    Surface surface;                 // the given triangles first, then those of the flange
    std::uint32_t part = 0;          // triangles of the given surface
    std::vector<std::uint32_t> root; // per vertex: of the given surface, itself or the one of the rim that it lies
                                     // straight out from
    std::vector<char> far;           // per triangle: it lies beyond the first of the depths
    double least = 0;                // mm: how deep the flange is where it is least,
    Vec3 least_at;                   // and where
    std::vector<Lid> lids;           // holes and notches that are closed
};

// The surface with a flange about every rim: straight on in its tangent planes, square to the rim, `depth` mm deep, and
// round about corners.  Where rims face each other, as across a hole or a notch, it is no deeper than half the way to
// the middle between them, by the balls that touch the rim and no other part of it (Amenta, Choi, Kolluri 2001): so the
// flange never meets itself there; in a sharp notch it ends.  It is built in two bands, the first `near` mm deep.
// Holes and notches without room for the depth are closed first (lids.hpp); no triangle of a lid is `far`.  `depth` >
// `near` > 0.
Flanged flanged(const Surface& surface, double near, double depth);

} // namespace filum::surface
