// Draws a surface and the path on it in parallel projection, as a map of the patch.
#pragma once

#include "render/layer.hpp"
#include "render/paint.hpp"
#include "render/view.hpp"

namespace filum::render {

struct DrapeView {
    int samples = 4;                  // samples per pixel; at most 256 are used
    std::vector<ViewDirection> looks; // several looks are drawn side by side
    Show show;
};

// Draws the surface shaded, its back darker, with rims and isolines.
// Beads lie on the side that their normals face, in their true width, later layers over earlier ones. Voids are points
// of the front that no bead covers. Overlaps are points covered by parts of one layer that are not neighbours along the
// path. Both are found per sample, so they do not depend on the mesh.
// Moves without material are thin lines where the surface does not hide them. Green dots mark the start and red dots
// the end of each stretch of path. A bar shows the scale.
// Same bytes for any `threads`. Throws Error(usage) if a requested field does not exist. Precondition: scene.sheet.
void draw_draped(Canvas& page, const Scene& scene, const Tint& tint, const DrapeView& view, int threads);

} // namespace filum::render
