// Turns outside the part, on a flange that is trimmed off later.
#pragma once

#include "surface/flange.hpp"
#include "surfpath/surfpath.hpp"

#include <optional>

namespace filum::surfpath {

// A sheet that is extended beyond its rims by a flange, on which paths turn (surface/flange.hpp).
struct Flange {
    surface::Sheet sheet;   // fields of the flange are those of the nearest rim
    std::uint32_t part = 0; // number of triangles of the part; they come first
    // per triangle: more than half a spacing outside the part, so that a line there covers nothing of it
    std::vector<char> far;
    double least = 0;               // mm: the least depth of the flange
    Vec3 least_at;                  // where the flange is least deep
    std::vector<surface::Lid> lids; // holes and notches that rows cross
};

// A flange of the depth that the options ask for, narrower in holes and notches. None if they ask for none or if the
// algorithm has no rows that end at rims. Sources that end at a rim are extended straight over the flange, except for
// fexa, which only uses their plane.
// Throws Error(usage) if the depth is less than a spacing.
std::optional<Flange> flange(const surface::Sheet& sheet, const Options& options);

// Whether the algorithm's lines end at rims.
bool has_rows(Algorithm algorithm);

// The options for planning on the flange's sheet.
Options on_flange(const Flange& flange, Options options);

// A place where the path leaves the part or returns to it.
struct Trim {
    std::size_t stroke = 0;
    double way = 0; // mm from the stroke's start
    Vec3 at;        // on the rim
};

struct Trims {
    std::vector<Trim> all; // in the order of the path
    double outside = 0;    // mm of path beyond the part
};

// Inserts places where the plan crosses edges of `surface`, and therefore where it crosses the rims of the part.
void thread(const Surface& surface, Plan& plan);

// The trims of a threaded plan on a flange's sheet. The triangles of the part are the first `part` ones.
Trims trims(const Plan& plan, std::uint32_t part);

// Adds the facts "trims" (crossings of the rims) and "outside" (mm of path outside the part), and notes for holes that
// are covered and where the flange is narrower than `depth`.
void report_trims(const Flange& flange, double depth, Plan& plan);

} // namespace filum::surfpath
