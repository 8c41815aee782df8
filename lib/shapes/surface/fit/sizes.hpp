// The intended lengths of sides, and the corners of rims and sharp edges that stay.
#pragma once

#include "geom/angle.hpp"
#include "surface/fit/editable.hpp"
#include "surface/fit/fitter.hpp"

namespace filum::surface::fit {

inline constexpr double kSharp = 30 * geom::kDegree; // rad between normals at an edge, or between sides at a corner

// Tolerances: shortest size that a tolerance can demand. On a sphere the longest side allowed turns by kSharp and
// deviates by the tolerance.
inline constexpr double kLeast = 8 / (kLong * kSharp);

struct Sizes {
    std::vector<double> wanted; // mm, per vertex
    std::vector<double> least;  // mm, per vertex: the most that curvature may demand
};

// Sizes of at most `longest` such that chords deviate by about `tolerance` from the curved surface, but at least the
// height of the triangles at its bends, whose interior shape is unknown, and at least kLeast tolerances; growing by at
// most half a millimetre per millimetre along edges.
Sizes sizes(const Surface& s, double longest, double tolerance);

// Reduces sizes until they grow no faster than that.
void grade(const Surface& s, std::vector<double>& sizes);

// The surface as an editable mesh. Corners where lines meet, end or bend by kSharp are fixed, and as many vertices
// along lines that the line is nowhere farther than `tolerance` from its chords and no chord is longer than the least
// size beside it.
Editable editable(const Surface& s, std::vector<double> sizes, double tolerance);

} // namespace filum::surface::fit
