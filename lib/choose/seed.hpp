// Where a candidate measures from, said so that it holds on any triangulation of the patch.
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
        side,      // of a rim, from `a` to `b` with the surface to its left; all of the rim if they are one
        plane,     // where it cuts the patch
        point,     // `a`
        stress,    // of field: along the stresses, which the patch carries
        direction, // of field: along `a` laid onto the patch
        along,     // the line through `a` along the pull, up to rims
        across,    // the same across the pull
        given      // what the patch came with
    };
    Kind kind = Kind::rims;
    surface::Plane plane{};
    Vec3 a{}, b{};
};

// In words: those of `geodesic --source` where it has some ("boundary", "plane:0,0,1,5", "point:1,2,3"), else "side:"
// with both ends, "along:" or "across:" with the point, "stress", "direction:" with it, "given".
std::string spoken(const Seed& seed);

// What the seeds of field ask of a patch: the vector field "direction", the same everywhere, or none, so that the
// stresses are followed.  Sources go.  Of other seeds: the sources that these are.
void put(Sheet& sheet, const std::vector<Vec3>& pull, const Seed& seed);

// The pull at every vertex: of all load cases' greatest stresses, in the tangent plane and by their sizes, the mean
// direction without sign (the main axis of the sum of s1 d1 d1^T; pressure counts nothing); of length 1, or 0 where
// there is none.  Empty if the sheet carries no load case.
std::vector<Vec3> pulls(const Sheet& sheet);

// The sources that the seed means on `sheet`; `pull` as pulls() of it.
// Throws Error(failure) if there are none: "the plane does not meet the surface".
surface::Sources sources(const Sheet& sheet, const std::vector<Vec3>& pull, const Seed& seed);

} // namespace filum::choose
