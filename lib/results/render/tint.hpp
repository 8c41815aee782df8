// The colours of beads, and the legend that explains them.
#pragma once

#include "machine/profile.hpp"
#include "render/colour.hpp"
#include "render/key.hpp"
#include "render/scene.hpp"

#include <array>
#include <set>
#include <string>

namespace filum::render {

enum class ColourBy { progress, stroke, tool, layer, width, speed, role };

// How beads are coloured. The ramp of `progress` runs from the first extruding move drawn to the last one. The ramp of
// `width` and `speed` runs from the 1st to the 99th percentile by length.
struct Tint {
    ColourBy by = ColourBy::progress;
    const machine::Profile* profile = nullptr;
    double lo = 0, hi = 1;                      // the amounts at the ends of the ramp
    std::vector<double> begin;                  // progress: mm extruded before each span
    std::size_t strokes = 0;                    // number of different strokes drawn
    std::set<std::uint32_t> tools;              // of By::tool: the tools drawn
    std::array<bool, toolpath::kRoles> roles{}; // the roles drawn
    std::array<bool, toolpath::kFeatures> features{};
    std::vector<Srgb8> ramp; // colours of the ramp, tabulated because mixing is slower
};

// The tint of a scene. By::speed shows the feeds of `profile`; else it may be null.
Tint tint(const Scene& scene, ColourBy by, const machine::Profile* profile);

// The colour of the segment i -> i + 1 of span `s`; the segment begins `along` mm from the start of the span.
Srgb8 colour(const Tint& tint, const Scene& scene, std::size_t s, std::size_t i, double along);

Rgb role_colour(toolpath::Role role);
const char* role_name(toolpath::Role role);
Rgb feature_colour(toolpath::Feature feature); // the colour of a bead with a known feature

// Draws the meaning of the colours: as items of a key, or alone in the lower left corner.
void add_legend(Key& key, const Tint& tint);
void draw_legend(Canvas& canvas, const Tint& tint);

} // namespace filum::render
