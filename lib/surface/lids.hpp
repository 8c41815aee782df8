// Holes and notches too narrow for a flange, closed.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface {

struct Lid {
    std::uint32_t vertex = 0; // of the surface, on the rim about it
    Vec3 middle;
    double area = 0;    // mm2
    bool notch = false; // of a rim that goes on, else of a hole
};

struct Closed {
    Surface surface; // the given vertices; the given triangles first, then those of the lids
    std::vector<Lid> lids;
};

// The surface with a lid on every hole (a rim that is not the outer one) where RimRoom finds `depth` nowhere, and on
// every notch: a stretch of a rim without that room anywhere, two sides of which look towards each other, opening by
// less than 60 degrees; its mouth is closed straight.  There is no lid where its rim crosses
// itself, seen square to it; where it lies more than 45 degrees off the surface beside it; or where another part of a
// rim lies in it: that is left open. `tolerance` as for RimRoom.
Closed with_lids(const Surface& s, double depth, double tolerance);

} // namespace filum::surface
