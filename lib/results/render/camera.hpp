// The camera of a picture in perspective, and rays through its pixels.
#pragma once

#include "render/scene.hpp"

namespace filum::render {

struct Camera {
    geom::Vec3 eye, forward, right, up; // right and up reach to the border of the picture at distance 1
    // The direction of the ray through the point (sx, sy) of the picture, both in [-1, 1], y upwards. Length 1.
    [[nodiscard]] geom::Vec3 ray(double sx, double sy) const;
};

inline geom::Vec3 unit(geom::Vec3 v) { return geom::unit(v, {0, 0, 1}); } // straight up if v has no length

// A camera in direction `from` that fits all points, relative to `centre`, into a picture with width / height =
// `aspect`, with a margin. Travels count if `travels` is set.
Camera aim(const Scene& scene, geom::Vec3 centre, geom::Vec3 from, double aspect, bool travels);

// The same for a ball around `at`, which is relative to the centre too.
Camera aim(geom::Vec3 at, double radius, geom::Vec3 from, double aspect);

} // namespace filum::render
