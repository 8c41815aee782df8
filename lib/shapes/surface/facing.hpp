// Which way a surface faces, and reversing it.
#pragma once

#include "surface/surface.hpp"

#include <span>

namespace filum::surface {

// The components that face inwards, as far as that can be determined: closed ones of negative volume; open ones that
// have a negative volume with lids on their rims and enclose it like half a cylinder or more, unless they mostly face
// up, like a mould that is filled from above; others that mostly face down, unless their volume is positive. A concave
// part of a larger surface, such as a fillet, is none.
struct InwardArea {
    double area = 0; // mm2
    std::uint64_t components = 0;
    Vec3 place;              // on the first of them
    std::vector<char> which; // per component of the surface
};
InwardArea inward(const Surface& s);

// The same surface with the components turned round that `which` marks. Triangles keep their numbers; corners b and c
// of a turned triangle a, b, c are swapped.
Surface flipped(const Surface& s, std::span<const char> which);

// The same surface facing the other way. If some components face inwards and others do not, only the former are turned.
Surface flipped(const Surface& s);

} // namespace filum::surface
