// Draws one layer from above.
#pragma once

#include "render/canvas.hpp"
#include "render/tint.hpp"

namespace filum::render {

struct FlatView {
    int samples = 4;                 // samples per pixel
    bool travels = true;             // whether travels are drawn, as thin lines
    bool centres = true;             // whether a thin line marks the middle of each bead
    std::vector<double> around = {}; // x, y, z, radius in mm of the circle that fills the page; empty: everything
};

// Draws beads in their true width, darker towards the border, so that neighbours can be distinguished. Where two
// stretches of path overlap by more than touching, the material is darker. Outlines are lines, and area inside them
// without a bead is red. A green dot marks the start and a red dot the end of every stroke; an orange dot marks a lift.
// A scene without beads shows the outlines filled. Same bytes for any `threads`.
// On a page for SVG or PDF, beads are lines of their true width, without shades and without marks of overlap.
void draw_flat(Canvas& page, const Scene& scene, const Tint& tint, const FlatView& view, int threads);

// The scale of that picture, in pixels per mm.
double flat_scale(const Scene& scene, const FlatView& view, int width, int height);

} // namespace filum::render
