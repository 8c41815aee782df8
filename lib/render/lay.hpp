// A toolpath on a surface, as a picture of it needs it.
#pragma once

#include "render/strokes.hpp"
#include "render/tint.hpp"

namespace filum::render {

// Beads are taken 2 % wider than true where they are drawn, or voids would show where they just touch.
inline constexpr double kFat = 1.02;

struct Laid {
    Strokes beads{{}};         // of all extruding spans, as wide as they are
    std::vector<Stroke> loose; // those that do not lie on the surface: farther from it than half their width and as
                               // many heights as their layer's number, seen from the side that their normals look to
    double length = 0, loose_length = 0; // mm: of all, and of those
    bool behind = false;                 // most of the path lies on the side that the surface does not face
};

// Spans without normals take those of the triangles nearest to them.  Precondition: scene.sheet.
Laid lay(const Scene& scene, const Tint& tint);

// Share of the side with the path that is farther than half a width from it, by 131072 samples spread evenly over the
// surface: off by about 0.1 % of it at most.
double uncovered(const surface::Surface& surface, const Laid& laid);

} // namespace filum::render
