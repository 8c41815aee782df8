// What lies on either side of a seed curve, and lines along it.
#pragma once

#include "geodesic/exact.hpp"
#include "surface/sheet.hpp"

#include <span>

namespace filum::surfpath {

// Triangles that hang together when all that hold seed segments are left out.
struct SeedSides {
    std::vector<std::uint32_t> of; // per triangle, kNone on the seed
    std::uint32_t count = 0;
};
SeedSides seed_sides(const surface::Surface& s, const surface::Sources& seed);

// The rim at which a side ends: what runs along the isolines of `distance` (per vertex) within 1.5 spacings of the
// farthest such place.
struct FarRim {
    surface::Sources rim;
    double mean = 0, length = 0; // mm: distance, size
};
FarRim far_rim(const surface::Surface& s, const SeedSides& sides, std::uint32_t side, std::span<const double> distance,
               double spacing);

// The spacing nearest to `spacing` at which the last line is half a spacing from the far rim; 0 if that is short, or
// more than 10 % off.
double step(const FarRim& rim, double spacing);

// step / 2, and on in steps, less than `end`.
std::vector<double> levels(double end, double step);

// Per side of the seed, lines along it, `spacing` apart, the first one half a spacing away.  If they are to be `fitted`
// and the side ends in a rim that runs along the seed, within 10 % of `spacing` they lie so that the last one is half a
// spacing from that rim all along: level sets of the distance from the seed as a share of that from both; else of the
// distance from the seed.  `field` and what else is measured is so on `closed`, which begins with the triangles of `s`.
std::vector<std::vector<surface::Isoline>> side_rows(const surface::Surface& s, const surface::Surface& closed,
                                                     const geodesic::ExactField& field, const surface::Sources& seed,
                                                     double spacing, bool fitted);

} // namespace filum::surfpath
