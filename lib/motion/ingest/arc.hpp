// Arcs in the XY plane, as the words of programs describe them.
#pragma once

#include "geom/vec.hpp"

#include <optional>
#include <vector>

namespace filum::ingest {

using geom::Vec3;

struct ArcWords {
    std::optional<double> i, j, r; // mm: the centre relative to the start, or the radius (negative: the longer arc)
    int turns = 1;                 // P
    bool clockwise = false;        // G2
    bool from_begin = true;        // false: I and J are absolute coordinates of the centre (G90.1)
};

// The points of an arc after its start; the last one is `to`. Lines between them deviate from the arc by at most
// `tolerance` mm, and z changes evenly. Returns no points if the words describe no arc.
std::vector<Vec3> arc_points(const Vec3& from, const Vec3& to, const ArcWords& words, double tolerance);

} // namespace filum::ingest
