// The directions of the lines at every vertex of a surface: prescribed, mixed, and smoothed until lines along them
// bend no tighter than a radius.
#pragma once

#include "base/note.hpp"
#include "surface/directions/rosy.hpp"
#include "surface/sheet.hpp"

namespace filum::surfpath::field {

using geom::Vec3;
using surface::Surface;
using surface::directions::Cells;
using surface::directions::Complex;

// spacings: radius over which directions are smoothed; lines cannot follow smaller features.
inline constexpr double kSmoothed = 0.2;

// Prescribed directions: per vertex the doubled angle (surface/directions/rosy.hpp) and its weight from 0 to 1.
struct PrescribedDirections {
    std::vector<Complex> z;
    std::vector<double> weight;
    double unknown = 0; // mm2 on which a prescribed field is not a finite number; nothing is prescribed there
    Vec3 unknown_at;    // one of these places
    double upright = 0; // mm2 where the reference direction is so close to the normal that it decides little
    Vec3 upright_at;    // one of these places
};

// The mixture of directions that lines follow; parts with a weight of 0 are left out.
struct DirectionMix {
    double given = 0;                // weight of the vector field named below
    double stress = 0;               // weight of the greatest tension of any load case
    double angle = 0;                // weight of the direction at `turn` from the reference direction
    double rim = 0;                  // weight of the direction of rims, at their vertices
    double rings = 0;                // weight of the lines of equal distance from the rims, everywhere
    double turn = 0;                 // rad, counter-clockwise as seen from the side that the surface faces
    const char* field = "direction"; // name of the vector field
    Vec3 reference{1, 0, 0};         // projected onto the surface; no direction where it is normal to that

    // Whether `weight` is the only weight above 0; for nullptr: whether there is none.
    [[nodiscard]] bool only(double DirectionMix::*weight) const;
};

// The weights with their names in options.
struct NamedWeight {
    const char* name;
    double DirectionMix::*weight;
};
inline constexpr NamedWeight kNamedWeights[] = {{"direction", &DirectionMix::given},
                                                {"stress", &DirectionMix::stress},
                                                {"angle", &DirectionMix::angle},
                                                {"rim", &DirectionMix::rim},
                                                {"rings", &DirectionMix::rings}};

inline bool DirectionMix::only(double DirectionMix::*weight) const {
    for (const NamedWeight& source : kNamedWeights)
        if ((this->*source.weight > 0) != (source.weight == weight)) return false;
    return true;
}

// The prescribed directions: the sum of weight times z over all parts, cut to length 1.
// Throws Error(bad_input) if the sheet lacks a part, as "the surface carries no tensile stress; run stressfield
// first".
PrescribedDirections prescribed(const surface::Sheet& sheet, const Cells& cells, const DirectionMix& sources);

struct Directions {
    std::vector<Vec3> along; // per vertex, unit, tangential, of either sign
    double tightest = 0;     // 1/mm: the greatest curvature of a line
    double tight = 0;    // mm2 where lines bend tighter than the radius although nothing is prescribed there any more
    Vec3 tight_at;       // where lines bend most
    double given_up = 0; // mm2 where less than half of the prescribed weight counts
};

// The directions that minimise the integral of weight |z - prescribed|^2 + length^2 |grad z|^2. Where lines along them
// bend tighter than `radius`, weights are lowered locally until lines bend no tighter or the weights are 0.
Directions smooth(const Surface& s, const Cells& cells, const PrescribedDirections& prescribed, double length,
                  double radius);

} // namespace filum::surfpath::field
