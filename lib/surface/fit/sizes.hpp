// How long sides of triangles shall be, and which corners of rims and sharp edges stay.
#pragma once

#include "geom/angle.hpp"
#include "surface/fit/editable.hpp"
#include "surface/fit/fitter.hpp"

namespace filum::surface::fit {

inline constexpr double kSharp = 30 * geom::kDegree; // rad between normals: an edge, or a corner of one

// The shortest sizes that a tolerance ever asks for, of it: on a ball, the longest side that is left by them turns by
// kSharp, and is off by the tolerance.
inline constexpr double kLeast = 8 / (kLong * kSharp);

struct Sizes {
    std::vector<double> wanted; // mm, per vertex
    std::vector<double> least;  // mm, per vertex: what bends ask for, at most
};

// At most `longest`; so short that chords are about `tolerance` off the surface, as its edges bend, but no shorter than
// triangles beside these are high, nor than kLeast asks for: what the surface is within its own triangles, these cannot
// tell; and nowhere growing faster than half a millimetre for each along an edge.
Sizes sizes(const Surface& s, double longest, double tolerance);

// Makes sizes so that they grow no faster than that.
void grade(const Surface& s, std::vector<double>& sizes);

// The surface, to be changed.  Corners where lines meet, end or bend by kSharp are fixed, and as many along lines that
// what lies between is nowhere farther than `tolerance` from its chord, and no chord longer than the least size beside
// it.
Editable editable(const Surface& s, std::vector<double> sizes, double tolerance);

} // namespace filum::surface::fit
