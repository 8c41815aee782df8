// Seed curves and seed planes.
#pragma once

#include "baselines/kipping2022/contours.hpp"
#include "surface/sources.hpp"

#include <optional>

namespace filum::baselines::kipping2022 {

// The plane that all sources lie in; of a straight line, the one that stands upright on the surface there.  None if
// they lie in none, or in a point.
std::optional<surface::Plane> plane_of(const Surface& s, const surface::Sources& sources);

// The distances with the sign of the side of the plane.  None if the plane meets the surface where they are beyond
// what `spacing` and the size of the triangles account for: it does not follow the seed curve there.
std::optional<std::vector<double>> signed_distances(const Surface& s, std::span<const double> phi,
                                                    const surface::Plane& plane, double spacing);

// The sources' segments as polylines: each begins at the first segment that is not in one yet.
struct SeedLine {
    bool closed = false;
    Points points;
};
std::vector<SeedLine> seed_lines(const surface::Sources& sources);

} // namespace filum::baselines::kipping2022
