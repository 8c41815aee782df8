// Which way a surface faces, and turning it round.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface {

// mm2 of the components that face inwards, as far as that can be known, and a place on the first of them:
// closed ones of negative volume; open ones that would have one if lids closed their rims, unless they mostly face up,
// as a mould that is filled from above; flat ones that mostly face down.
struct Inward {
    double area = 0;
    std::uint64_t components = 0;
    Vec3 place;
};
Inward inward(const Surface& s);

// The same surface, facing the other way.  Triangles keep their numbers; corners b and c of a triangle a, b, c change
// places.
Surface flipped(const Surface& s);

} // namespace filum::surface
