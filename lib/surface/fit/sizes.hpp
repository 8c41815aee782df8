// How long sides of triangles shall be, and which corners of rims and sharp edges stay.
#pragma once

#include "geom/angle.hpp"
#include "surface/fit/editable.hpp"

namespace filum::surface::fit {

inline constexpr double kSharp = 30 * geom::kDegree; // rad between normals: an edge, or a corner of one

// The shortest sides that a tolerance ever asks for, mm: a chord across a bend of kSharp is then as far off.
inline constexpr double kLeast = 4 / kSharp; // tolerances

// Per vertex, mm: at most `longest`; so short that a chord there is about `tolerance` off the surface, as edges bend,
// but no shorter than kLeast asks for; and nowhere growing faster than half a millimetre for each along an edge.
std::vector<double> sizes(const Surface& s, double longest, double tolerance);

// Makes sizes so that they grow no faster than that.
void grade(const Surface& s, std::vector<double>& sizes);

// The surface, to be changed.  Corners where lines meet, end or bend by kSharp are fixed, and as many along lines that
// what lies between is nowhere farther than `tolerance` from its chord, and no chord longer than the least size beside
// it.
Editable editable(const Surface& s, std::vector<double> sizes, double tolerance);

} // namespace filum::surface::fit
