// Draws a toolpath in perspective: beads on a table, lit by a lamp and a bright sky.
#pragma once

#include "render/image.hpp"
#include "render/tint.hpp"

#include <optional>

namespace filum::render {

struct ViewSphere {
    geom::Vec3 centre;
    double radius = 0; // mm
};

struct View {
    geom::Vec3 from{1, -1.5, 0.9};         // direction from the part to the camera; not zero
    int samples = 4;                       // rays per pixel; more rays give less noise
    bool travels = false;                  // whether travels are drawn, as thin threads
    bool table = true;                     // whether the part stands on a table that shows its shadow
    std::optional<ViewSphere> around = {}; // the ball that fills the picture; none: everything
};

// Draws beads with elliptic sections: their true width, and the height of a typical layer of the scene. They are
// Embree's round linear curves in a space stretched along z. Memory: up to 16 bytes per point and 8 per segment,
// besides Embree's own tree.
// One lamp over the viewer's left shoulder gives soft shadows, and near objects dim the light of the sky (ambient
// occlusion). An empty scene gives an empty table. Same bytes for any `threads` (0: all cores). Throws Error(failure)
// if Embree does not start.
void draw_perspective(Canvas& canvas, const Scene& scene, const Tint& tint, const View& view, int threads);

} // namespace filum::render
