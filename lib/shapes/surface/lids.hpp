// Closes holes and notches that are too narrow for a flange.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface {

struct Lid {
    std::uint32_t vertex = 0; // of the surface, on the rim around it
    Vec3 middle;
    double area = 0;    // mm2
    bool notch = false; // whether it closes a notch of a rim rather than a hole
};

struct SurfaceWithLids {
    Surface surface; // the given vertices; the given triangles first, then those of the lids
    std::vector<Lid> lids;
};

// The surface with a lid on every hole (a rim other than the outer one) in which RimRoom finds `depth` nowhere, and on
// every notch: a stretch of a rim without that room, where two of its sides face each other at less than 60 degrees;
// its mouth is closed straight. No lid is made if its rim crosses itself in projection, if the lid is inclined by more
// than 45 degrees to the surface beside it, or if another part of a rim is inside it. `tolerance` as for RimRoom.
SurfaceWithLids with_lids(const Surface& s, double depth, double tolerance);

} // namespace filum::surface
