// Draws one layer from above, as pixels or as SVG.
#pragma once

#include "render/image.hpp"
#include "render/tint.hpp"

namespace filum::render {

struct FlatView {
    int width = 1024, height = 768; // pixels
    int samples = 4;                // samples per pixel
    bool travels = true;            // whether travels are drawn, as thin lines
    bool centres = true;            // whether a thin line marks the middle of each bead
};

// Draws beads in their true width, darker towards the border, so that neighbours can be distinguished. Where two
// stretches of path overlap by more than touching, the material is darker. Outlines are lines, and area inside them
// without a bead is red. A green dot marks the start and a red dot the end of every stroke; an orange dot marks a lift.
// A scene without beads shows the outlines filled. Same bytes for any `threads`.
Image draw_flat(const Scene& scene, const Tint& tint, const FlatView& view, int threads);

// The same layer as SVG with true stroke widths in mm. y points up on the page.
std::string svg(const Scene& scene, const Tint& tint, const FlatView& view);

} // namespace filum::render
