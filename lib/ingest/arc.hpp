// Arcs in XY, as programs say them.
#pragma once

#include "geom/vec.hpp"

#include <optional>
#include <vector>

namespace filum::ingest {

using geom::Vec3;

struct ArcWords {
    std::optional<double> i, j, r; // mm: the centre from the begin, or the radius (negative: the long way)
    int turns = 1;                 // P
    bool clockwise = false;        // G2
    bool from_begin = true;        // false: I and J are the centre itself (G90.1)
};

// Points of the arc behind its begin, the last one `to`, no farther off than `tolerance`; z goes evenly.  Nothing if
// the words describe no arc.
std::vector<Vec3> arc_points(const Vec3& from, const Vec3& to, const ArcWords& words, double tolerance);

} // namespace filum::ingest
