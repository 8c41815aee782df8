// Which colour a bead has, and the legend that explains it.
#pragma once

#include "machine/profile.hpp"
#include "render/colour.hpp"
#include "render/key.hpp"
#include "render/scene.hpp"

#include <array>
#include <string>

namespace filum::render {

enum class By { progress, stroke, layer, width, speed, role };

// Progress: from the first extruding move drawn to the last one.  Width, speed: from the 1st to the 99th percentile by
// length.
struct Tint {
    By by = By::progress;
    const machine::Profile* profile = nullptr;
    double lo = 0, hi = 1;                      // what the ramp's ends stand for
    std::vector<double> begin;                  // progress: mm extruded before each span
    std::size_t strokes = 0;                    // distinct ones drawn
    std::array<bool, toolpath::kRoles> roles{}; // drawn ones
    std::array<bool, toolpath::kFeatures> features{};
    std::vector<Srgb8> ramp; // steps of the ramp: looked up faster than mixed
};

// `profile`: whose feeds By::speed shows; null for anything else.
Tint tint(const Scene& scene, By by, const machine::Profile* profile);

// Colour of the segment i -> i + 1 of span `s`, which begins `along` mm from the span's start.
Srgb8 colour(const Tint& tint, const Scene& scene, std::size_t s, std::size_t i, double along);

Rgb role_colour(toolpath::Role role);
const char* role_name(toolpath::Role role);
Rgb feature_colour(toolpath::Feature feature); // of a bead that has one

// What the colours mean; alone, in the lower left corner.
void add_legend(Key& key, const Tint& tint);
void draw_legend(Image& image, const Tint& tint);

} // namespace filum::render
