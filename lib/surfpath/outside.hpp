// Turns beyond the rims of a part, which is trimmed there later.
#pragma once

#include "surface/flange.hpp"
#include "surfpath/surfpath.hpp"

#include <optional>

namespace filum::surfpath {

// A sheet with a flange about it, to lay paths on (surface/flange.hpp).
struct Flange {
    surface::Sheet sheet;   // fields as on the rim next to it
    std::uint32_t part = 0; // triangles of the part: they come first
    std::vector<char> far;  // per triangle: farther than half a spacing beyond the part: what lies there covers nothing
    double least = 0;       // mm, of its depth,
    Vec3 least_at;          // and where
    std::vector<surface::Lid> lids; // holes and notches that rows go straight across
};

// As deep as the options ask; narrower in holes and notches.  None if they do not, or their algorithm has no rows that
// end at rims.  Sources that end at a rim go straight on over the flange, but for fexa, which needs only their plane.
// Throws Error(usage) if that is less than a spacing.
std::optional<Flange> flange(const surface::Sheet& sheet, const Options& options);

// Whether its lines end at rims.
bool has_rows(Algorithm algorithm);

// The options for a plan on the flange's sheet.
Options on_flange(const Flange& flange, Options options);

// Where the path leaves the part, or comes back.
struct Trim {
    std::size_t stroke = 0;
    double way = 0; // mm along the stroke
    Vec3 at;        // on the rim
};

struct Trims {
    std::vector<Trim> all; // along the path
    double outside = 0;    // mm of path beyond the part
};

// Puts places wherever the plan crosses edges of `surface`, and so the rims of the part that lies in it.
void thread(const Surface& surface, Plan& plan);

// Of a threaded plan on a flange's sheet, whose first `part` triangles are the part.
Trims trims(const Plan& plan, std::uint32_t part);

// Adds to the plan the facts "trims", how often it crosses the rims, and "outside", mm beyond them; and notes of holes
// that are laid over, and where the flange is less deep than `depth`.
void tell_trims(const Flange& flange, double depth, Plan& plan);

} // namespace filum::surfpath
