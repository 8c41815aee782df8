// Where the picture is taken from, and rays through its pixels.
#pragma once

#include "render/scene.hpp"

namespace filum::render {

struct Camera {
    geom::Vec3 eye, forward, right, up; // right and up: to the border of the picture at distance 1
    // Direction through the point (sx, sy) of the picture, both in [-1, 1], y upwards; length 1.
    [[nodiscard]] geom::Vec3 ray(double sx, double sy) const;
};

inline geom::Vec3 unit(geom::Vec3 v) { return geom::unit(v, {0, 0, 1}); } // straight up for no length

// Looks from direction `from` so that all points, taken relative to `centre`, fill a picture of width / height =
// `aspect`, but for a margin.
Camera aim(const Scene& scene, geom::Vec3 centre, geom::Vec3 from, double aspect, bool travels);

// The same for a ball around `at`, relative to the same centre.
Camera aim(geom::Vec3 at, double radius, geom::Vec3 from, double aspect);

} // namespace filum::render
