// Evenly spaced stripes along given directions: a phase at every vertex, whose half turns are the lines.
#pragma once

#include "surface/curve/line.hpp"
#include "surfpath/field/directions.hpp"

namespace filum::surfpath::field {

using surface::curve::Line;

// A complex phase per vertex. Along an edge its angle grows as nearly as possible as directions and spacing demand.
// Directions have no sign, so the two ends of an edge may count angles in opposite directions.
struct Stripes {
    std::vector<Complex> phase; // per vertex, of size 1
    // Per half-edge, equal for both halves: growth of the angle from the end with the lower number to the other one,
    // as counted at the first. Lines are where the angle is an odd number of right angles.
    std::vector<double> growth;
    std::vector<char> flipped; // per half-edge, equal for both halves: the other end counts in the opposite direction
};

// The weight `stiff` of slopes along the lines that keeps angles. An error of the direction by some angle costs as much
// as an error of the spacing by sqrt(stiff) times that share: half a degree as much as a twentieth of a spacing.
inline constexpr double kKeepAngle = 33;

struct StripeOptions {
    double spacing = 1; // mm
    double shift = 0;   // spacings by which lines are displaced, except along rims
    double stiff = 1;   // 1, which weighs directions and spacing alike, or more
    double change = 0;  // share by which lines may be nearer to each other or farther apart, so that fewer begin
    // per vertex an initial phase that may be near the optimum, of size 1 (0: unknown); may be empty
    std::span<const Complex> like{};
    std::span<const Vec3> apart{}; // places that repel births, as far as that costs little
};

// Stripes whose lines follow `along`, one spacing apart. They minimise the integral of |grad psi - i w psi|^2 with
// |psi| = 1 and w = pi / spacing across the direction; slopes along it are weighted by `stiff`. The functional is that
// of Knoppel, Crane, Pinkall, Schroeder 2015, "Stripe patterns on surfaces". But psi keeps size 1 everywhere
// (threshold dynamics: diffuse, scale to size 1, for falling times), because eigenvectors vanish where directions
// diverge, and their phase is noise there.
// Two initial phases are tried: a constant one, and `like` if given; the result of lower energy is taken. Rims along
// which lines run attract the middle between two lines. Near repelling places slopes cost more, so that births move
// away. A period contains two lines: where directions diverge, two lines begin together, joined by a turn, so no line
// ends inside the surface.
// Throws Error(failure) if the triangles are too uneven for the linear system.
Stripes stripes(const Surface& s, const Cells& cells, std::span<const Vec3> along, const StripeOptions& options);

// Whether the angle does not return to its value around the triangle: lines are born there, or the corners' directions
// have no common sign.
bool singular(const Surface& s, const Stripes& stripes, std::uint32_t triangle);

// The middles of triangles where two lines begin or end together, in the order of triangles.
std::vector<Vec3> births(const Surface& s, const Stripes& stripes);

// The lines, where the angle of the stripes is an odd number of right angles: threaded, open from rim to rim or
// closed, in the order of their first half-edges. In a singular triangle the crossings can be connected in two ways;
// the shorter one is taken, unless the other one connects a closed line to another line.
std::vector<Line> lines(const Surface& s, const Stripes& stripes);

} // namespace filum::surfpath::field
