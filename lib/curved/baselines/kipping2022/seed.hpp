// Seed curves and seed planes.
#pragma once

#include "baselines/kipping2022/contours.hpp"
#include "surface/sources.hpp"

#include <optional>

namespace filum::baselines::kipping2022 {

// The plane of all sources; for a straight line the one perpendicular to the surface there. None if they are not
// coplanar, or in one point.
std::optional<surface::Plane> plane_of(const Surface& s, const surface::Sources& sources);

// The distances with the sign of the plane's side. None if the plane meets the surface at distances greater than
// `spacing` and the size of triangles account for, as it then does not follow the seed curve.
std::optional<std::vector<double>> signed_distances(const Surface& s, std::span<const double> phi,
                                                    const surface::Plane& plane, double spacing);

// The sources' segments as polylines; each starts at the first unused segment.
struct SeedLine {
    bool closed = false;
    Points points;
};
std::vector<SeedLine> seed_lines(const surface::Sources& sources);

} // namespace filum::baselines::kipping2022
