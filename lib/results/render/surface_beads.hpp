// The beads of a toolpath on a surface, prepared for drawing.
#pragma once

#include "render/strokes.hpp"
#include "render/tint.hpp"

namespace filum::render {

// The factor by which beads are drawn wider than they are. Otherwise voids would appear where beads just touch.
inline constexpr double kFat = 1.02;

struct SurfaceBeads {
    Strokes beads{{}}; // all extruding spans, widened by kFat
    // Beads that do not lie on the surface, seen from the side that their normals face. They are farther from it than
    // half their width plus as many heights as the number of their layer.
    std::vector<Stroke> loose;
    bool behind = false; // whether most of the path lies on the back of the surface
};

// Finds the beads of the scene and whether they lie on its surface. Spans without normals get those of the nearest
// triangles. Precondition: scene.sheet.
SurfaceBeads surface_beads(const Scene& scene, const Tint& tint);

// The share of the side with the path that is farther than half a bead width from the path. Estimated with 131072
// samples spread evenly over the surface; the error is about 0.1 % of the surface at most.
double uncovered(const surface::Surface& surface, const SurfaceBeads& laid);

} // namespace filum::render
