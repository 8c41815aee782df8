// Extends a surface beyond its rims by a flange, which is trimmed off the part later.
#pragma once

#include "surface/lids.hpp"

namespace filum::surface {

struct FlangedSurface {
    Surface surface;                 // the triangles of the given surface first, then those of the flange
    std::uint32_t part = 0;          // number of triangles of the given surface
    std::vector<std::uint32_t> root; // per vertex: of the given surface, itself or the vertex of the rim nearest to it
    std::vector<char> far;           // per triangle: it is beyond the first band
    double least = 0;                // mm: least depth of the flange
    Vec3 least_at;                   // where that is
    std::vector<Lid> lids;           // holes and notches that were closed
};

// The surface with a flange along every rim: straight in the tangent planes, perpendicular to the rim, `depth` mm
// deep, and with fans around convex corners. Where parts of rims face each other, as across a hole or a notch, its
// depth is at most half the way to the middle between them, measured by balls that touch the rim at a place and
// contain no other point of a rim (Amenta, Choi, Kolluri 2001). So the flange never meets itself there; in a sharp
// notch it ends. It consists of two bands; the first is `near` mm deep.
// Holes and notches without room for the depth are closed first (lids.hpp); no triangle of a lid is `far`.
// Precondition: `depth` > `near` > 0.
FlangedSurface flanged(const Surface& surface, double near, double depth);

} // namespace filum::surface
