// A toolpath in perspective: beads as they lie, lit by a lamp and a bright sky, on a table.
#pragma once

#include "render/image.hpp"
#include "render/tint.hpp"

#include <optional>

namespace filum::render {

struct Around {
    geom::Vec3 centre;
    double radius = 0; // mm
};

struct View {
    int width = 1024, height = 768;    // pixels
    geom::Vec3 from{1, -1.5, 0.9};     // direction from the part to the camera; not zero
    int samples = 4;                   // rays per pixel; more rays, less noise
    bool travels = false;              // draw them, too, as thin threads
    bool table = true;                 // the part stands on something that takes its shadow
    std::optional<Around> around = {}; // fills the picture; else all does
};

// Beads are drawn with elliptic sections, as wide as they are and as high as the scene's typical layer, with Embree's
// round linear curves in a space stretched along z; so up to 16 bytes per point and 8 per segment, beside Embree's own
// tree. Light: one lamp with soft shadow over the viewer's left shoulder, and a sky that is dimmed by what is near
// (ambient occlusion).  An empty scene gives an empty table.  Same bytes for any `threads` (0: all cores). Throws
// Error(failure) if Embree does not start.
Image draw_perspective(const Scene& scene, const Tint& tint, const View& view, int threads);

} // namespace filum::render
