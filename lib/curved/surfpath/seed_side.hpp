// The two sides of a seed curve, and lines along it.
#pragma once

#include "geodesic/exact.hpp"
#include "surface/sheet.hpp"

#include <span>

namespace filum::surfpath {

// The sides of a seed: connected sets of triangles that contain no seed segment.
struct SeedSides {
    std::vector<std::uint32_t> of; // per triangle, kNone on the seed
    std::uint32_t count = 0;
};
SeedSides seed_sides(const surface::Surface& s, const surface::Sources& seed);

// The rim at which a side ends: sides of rims along which `distance` (per vertex) is almost constant, within 1.5
// spacings of the farthest of these.
struct FarRim {
    surface::Sources rim;
    double mean = 0, length = 0; // mm: distance from the seed, and length of the rim
};
FarRim far_rim(const surface::Surface& s, const SeedSides& sides, std::uint32_t side, std::span<const double> distance,
               double spacing);

// The spacing nearest to `spacing` at which the last line lies half a spacing from the far rim. 0 if that rim is
// short, or if the spacing would change by more than 10 %.
double step(const FarRim& rim, double spacing);

// step / 2, 3 step / 2 and so on, as long as they are less than `end`.
std::vector<double> levels(double end, double step);

// Per side of the seed the lines along it, `spacing` apart, the first one half a spacing away. They are level sets of
// the distance from the seed. If they are to be `fitted` and the side ends in a rim that runs along the seed, the
// spacing changes by up to 10 % so that the last line lies half a spacing from that rim; the lines are then level sets
// of the distance from the seed as a share of the distances from seed and rim. `field` and all distances are measured
// on `closed`, which begins with the triangles of `s`.
std::vector<std::vector<surface::Isoline>> side_rows(const surface::Surface& s, const surface::Surface& closed,
                                                     const geodesic::ExactField& field, const surface::Sources& seed,
                                                     double spacing, bool fitted);

} // namespace filum::surfpath
