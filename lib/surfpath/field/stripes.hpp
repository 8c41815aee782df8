// Stripes along given directions, evenly apart: a phase at every vertex, whose half turns are the lines.
#pragma once

#include "surface/curve/line.hpp"
#include "surfpath/field/directions.hpp"

namespace filum::surfpath::field {

using surface::curve::Line;

// A complex number per vertex; seen along a side of a triangle its angle grows by what `along` and the spacing say, as
// nearly as may be.  Directions have no sign, so from vertex to vertex angles may count the other way round.
struct Stripes {
    std::vector<Complex> phase; // per vertex, of size 1
    // Per half-edge, both halves alike: by how much the angle grows from the end with the lesser number to the other,
    // counted as at the first.  A line is where the angle is an odd number of right angles.
    std::vector<double> growth;
};

// Stripes whose lines run along `along`, `spacing` mm apart.  Least of |grad psi - i w psi|^2 over the area, |psi| = 1,
// with w = pi / spacing across the direction: Knoppel, Crane, Pinkall, Schroeder 2015, "Stripe patterns on surfaces",
// but with size 1 everywhere (threshold dynamics: diffuse, then scale to 1, for falling times), since eigenvectors die
// out where directions spread, and what is left of them there says nothing.  Rims along which lines run attract the
// middle between two lines, so that the last line is half a spacing from the rim.
// The period holds two lines: where directions spread, lines are born in twos, joined by a turn, and none ever ends
// within the surface.
Stripes stripes(const Surface& s, const Cells& cells, std::span<const Vec3> along, double spacing);

// The lines: where the stripes' angle is an odd number of right angles.  Threaded, open from rim to rim or closed, in
// the order of their first half-edges.
std::vector<Line> lines(const Surface& s, const Stripes& stripes);

} // namespace filum::surfpath::field
