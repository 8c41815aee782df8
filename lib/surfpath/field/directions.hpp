// Along what lines shall run, everywhere on a surface: given, mixed, and smoothed until they bend no tighter than
// asked.
#pragma once

#include "base/note.hpp"
#include "surface/directions/rosy.hpp"
#include "surface/sheet.hpp"

namespace filum::surfpath::field {

using geom::Vec3;
using surface::Surface;
using surface::directions::Cells;
using surface::directions::Complex;

// Per vertex a direction as its doubled angle (rosy.hpp), and how much it counts, 0 to 1.
struct Wanted {
    std::vector<Complex> z;
    std::vector<double> weight;
    double unknown = 0; // mm2 where a field that is to be followed holds no number: there nothing is wanted
    Vec3 unknown_at;    // one of these places
};

// What of it is wanted, and how much: weights of 0 leave it out.
struct Sources {
    double given = 0;                // along the field of vectors that is named below
    double stress = 0;               // along the greatest pull of any load case
    double angle = 0;                // at `turn` from the reference direction
    double rim = 0;                  // along the rims, where one is near
    double rings = 0;                // along the lines of equal distance from the rims, everywhere
    double turn = 0;                 // rad, counter-clockwise seen from the side that the surface faces
    const char* field = "direction"; // of that
    Vec3 reference{1, 0, 0};         // laid onto the surface; where it stands upright on that it says nothing

    // Whether this is wanted, and nothing else; of none, whether nothing is.
    [[nodiscard]] bool only(double Sources::*weight) const;
};

// The weights, as users have them.
struct NamedSource {
    const char* name;
    double Sources::*weight;
};
inline constexpr NamedSource kSources[] = {{"direction", &Sources::given},
                                           {"stress", &Sources::stress},
                                           {"angle", &Sources::angle},
                                           {"rim", &Sources::rim},
                                           {"rings", &Sources::rings}};

inline bool Sources::only(double Sources::*weight) const {
    for (const NamedSource& source : kSources)
        if ((this->*source.weight > 0) != (source.weight == weight)) return false;
    return true;
}

// The mix of the sources: the sum of weight times z, of length at most 1.
// Throws Error(bad_input) if there is none of a source: "the surface carries no stresses; run stressfield first".
Wanted wanted(const surface::Sheet& sheet, const Cells& cells, const Sources& sources);

struct Directions {
    std::vector<Vec3> along; // per vertex, unit, across its normal, of either sign
    double tightest = 0;     // 1/mm: the most that a line bends anywhere
    double tight = 0;        // mm2 where lines bend tighter than asked for, though nothing is wanted there any more
    Vec3 tight_at;           // where they bend most
    double given_up = 0;     // mm2 where less than half of what was wanted counts
};

// The directions with the least sum over area of weight |z - wanted|^2 + length^2 |grad z|^2.  Where lines along them
// would bend tighter than `radius`, weights fall, there only, until they do not, or nothing is wanted there any more.
Directions smooth(const Surface& s, const Cells& cells, const Wanted& wanted, double length, double radius);

} // namespace filum::surfpath::field
