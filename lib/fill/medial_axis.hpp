// The medial axis of a planar area, with the distance to the outline (Boost.Polygon's Voronoi diagram of segments).
#pragma once

#include "polygon/loops.hpp"

#include <cstdint>
#include <vector>

namespace filum::fill {

using geom::Vec2;
using polygon::Loops;

// A graph: edge k runs from vertex a[k] to b[k], straight (curved pieces are cut into short chords).
struct MedialAxis {
    std::vector<Vec2> point;
    std::vector<double> radius; // per vertex, mm: distance to the nearest outline
    std::vector<std::uint32_t> a, b;
};

// The part of the medial axis inside `area` (simple; outer loops counter-clockwise).  Coordinates are rounded to 0.1 um
// about the middle of the box; the box may be up to 400 m wide.  Curved pieces are cut into chords of at most `step`
// mm.
MedialAxis medial_axis(const Loops& area, double step);

// The same graph with a vertex wherever an edge passes `radius`.
MedialAxis split_at(const MedialAxis& axis, double radius);

} // namespace filum::fill
