// The seed of a candidate path, described independently of the patch's triangles.
#pragma once

#include "surface/sheet.hpp"

#include <string>

namespace filum::choose {

using geom::Vec3;
using surface::Sheet;
using surface::Surface;

struct Seed {
    enum class Kind {
        rims,      // all of them
        side,      // of a rim, from `a` to `b` with the surface on its left; the whole rim if they are equal
        plane,     // where it intersects the patch
        point,     // `a`
        stress,    // of field: along the stresses that the patch carries
        direction, // of field: along `a`, projected onto the patch
        along,     // the line through `a` along the tension, up to rims
        across,    // the same across the tension
        given      // the sources that the patch carries
    };
    Kind kind = Kind::rims;
    surface::Plane plane{};
    Vec3 a{}, b{};
};

// The seed as text: as in `geodesic --source` where that has it ("boundary", "plane:0,0,1,5", "point:1,2,3"),
// otherwise "side:" with both ends, "along:" or "across:" with the point, "stress", "direction:" with the vector,
// "given".
std::string spoken(const Seed& seed);

// Prepares the patch for the seed. For seeds of field: sets the vector field "direction" to a constant, or removes it
// so that stresses are followed; sources are removed. For other seeds: sets the sources.
void put(Sheet& sheet, const std::vector<Vec3>& pull, const Seed& seed);

// The tension at every vertex: the mean direction without sign of all load cases' greatest stresses in the tangent
// plane, weighted by size (the principal axis of the sum of s1 d1 d1^T; pressure does not count); of length 1, or 0
// where there is none. Empty without load cases.
std::vector<Vec3> pulls(const Sheet& sheet);

// The sources of the seed on `sheet`; `pull` is pulls(sheet).
// Throws Error(failure) if there are none, as "the plane does not meet the surface".
surface::Sources sources(const Sheet& sheet, const std::vector<Vec3>& pull, const Seed& seed);

} // namespace filum::choose
