// The content of a picture of one layer, for pixels or SVG.
#pragma once

#include "render/tint.hpp"

namespace filum::render {

// A straight piece of a bead, mm.
struct FlatBead {
    geom::Vec2 a, b;
    double width = 0;
    double along = 0;        // mm of path before it; distinguishes neighbours along the path from neighbouring lanes
    std::uint32_t span = 0;  // index of the span in the scene
    std::uint32_t point = 0; // index of its first point in the span
};

struct Mark {
    enum class Kind : std::uint8_t { start, end, lift };
    Kind kind = Kind::start;
    geom::Vec2 at;
};

struct FlatLayer {
    std::vector<FlatBead> beads;
    std::vector<FlatBead> travels; // with width 0
    std::vector<Mark> marks;       // starts and ends of every stretch without a gap, and lifts
    geom::Box2 box;                // bounds of beads and outlines
    double width = 0.4;            // mm, width of a typical bead
};

FlatLayer flatten(const Scene& scene);

Rgb mark_colour(Mark::Kind kind);

} // namespace filum::render
