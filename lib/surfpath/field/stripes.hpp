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
    std::vector<char> flipped; // likewise: the other end counts the other way round
};

// How stripes share out what cannot be had: being off the direction by an angle costs as much as being off the spacing
// by sqrt(stiff) times that share.
inline constexpr double kEven = 1;
inline constexpr double kTrue = 33; // half a degree is as bad as a twentieth of a spacing

struct Striping {
    double spacing = 1;   // mm
    double shift = 0;     // of a spacing: lines lie that much beside where they would else, but those at rims
    double stiff = kEven; // from 1 on
    std::span<const Complex> like{}; // per vertex: a phase that may be near the best, of size 1 (0: not known); or none
    std::span<const Vec3> apart{};   // places from which births keep away, as far as that costs little
};

// Stripes whose lines run along `along`, one spacing apart.  Least of |grad psi - i w psi|^2 over the area, |psi| = 1,
// with w = pi / spacing across the direction, slopes along it counting `stiff` times: Knoppel, Crane, Pinkall,
// Schroeder 2015, "Stripe patterns on surfaces", but with size 1 everywhere (threshold dynamics: diffuse, then scale to
// 1, for falling times), since eigenvectors die out where directions spread, and what is left of them there says
// nothing.  Begun with the same phase everywhere, and with the one that is given; the one of less sum is taken.  Rims
// along which lines run attract the middle between two lines, so that the last line is half a spacing
// from the rim. Near places to keep apart from slopes cost more, so that births lie beside them. The period holds two
// lines: where directions spread, lines are born in twos, joined by a turn, and none ever ends within the surface.
Stripes stripes(const Surface& s, const Cells& cells, std::span<const Vec3> along, const Striping& options);

// Whether the angle does not come back to what it was, once round the triangle: there lines are born, or directions
// have no sign that all three corners agree on.
bool singular(const Surface& s, const Stripes& stripes, std::uint32_t triangle);

// Where two lines are born, or end, joined by a turn: in the order of triangles, their middles.
std::vector<Vec3> births(const Surface& s, const Stripes& stripes);

// The lines: where the stripes' angle is an odd number of right angles.  Threaded, open from rim to rim or closed, in
// the order of their first half-edges.  In singular triangles there are two ways to join those that meet; the shorter
// one, unless the other makes a closed line part of another.
std::vector<Line> lines(const Surface& s, const Stripes& stripes);

} // namespace filum::surfpath::field
