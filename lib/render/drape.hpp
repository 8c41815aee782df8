// A surface, and the path on it, in parallel projection: a map of the patch that it looks at.
#pragma once

#include "render/layer.hpp"
#include "render/paint.hpp"
#include "render/view.hpp"

namespace filum::render {

struct DrapeView {
    int width = 1024, height = 768; // pixels
    int samples = 4;                // per pixel, both ways together; at most 256 are taken
    std::vector<Look> looks;        // several: side by side
    Show show;
};

// The surface shaded, its back darker, with rims and isolines; beads lie on the side that their normals look to, as
// wide as they are, later layers over earlier ones.  Voids are the points of the front that no bead covers, overlaps
// those that parts of one layer cover that are no neighbours along the path: both per sample, so the mesh does not
// matter.  Moves without material are thin lines where the surface does not hide them; green dots are where a stretch
// of path begins, red ones where it ends.  A bar tells the scale.  Same bytes for any `threads`.
// Throws Error(usage) if a field to be shown is not there.  Precondition: scene.sheet.
Image draw_draped(const Scene& scene, const Tint& tint, const DrapeView& view, int threads);

} // namespace filum::render
