// What a picture of one layer holds, raster or SVG.
#pragma once

#include "render/tint.hpp"

namespace filum::render {

// A straight bead in its place, mm.
struct FlatBead {
    geom::Vec2 a, b;
    double width = 0;
    double along = 0;        // mm of path before it, to tell neighbours on the path from neighbouring lanes
    std::uint32_t span = 0;  // of the scene
    std::uint32_t point = 0; // it runs from this point of the span to the next
};

struct Mark {
    enum class Kind : std::uint8_t { start, end, lift };
    Kind kind = Kind::start;
    geom::Vec2 at;
};

struct FlatLayer {
    std::vector<FlatBead> beads;
    std::vector<FlatBead> travels; // width 0
    std::vector<Mark> marks;       // of every stretch without a gap
    geom::Box2 box;                // around beads and outlines
    double width = 0.4;            // mm, of a typical bead
};

FlatLayer flatten(const Scene& scene);

Rgb mark_colour(Mark::Kind kind);

} // namespace filum::render
