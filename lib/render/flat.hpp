// One layer from above, as pixels or as SVG.
#pragma once

#include "render/image.hpp"
#include "render/tint.hpp"

namespace filum::render {

struct FlatView {
    int width = 1024, height = 768; // pixels
    int samples = 4;                // per pixel, both ways together
    bool travels = true;            // as thin lines
    bool centres = true;            // a thin line along the middle of the beads
};

// Beads as wide as they are, darker to the border, so that neighbours can be told; where two stretches of path overlap
// by more than touching, the material is drawn darker.  The outlines, if any, are drawn as lines, and what no bead
// reaches inside them is red.  Start and end of every stroke get a green and a red dot, lifts an orange one.  A scene
// without beads shows the outlines filled. Same bytes for any `threads`.
Image draw_flat(const Scene& scene, const Tint& tint, const FlatView& view, int threads);

// The same as SVG with true stroke widths, in mm; y upwards on the part is up on the page.
std::string svg(const Scene& scene, const Tint& tint, const FlatView& view);

} // namespace filum::render
