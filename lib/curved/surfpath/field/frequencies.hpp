// How dense lines along given directions should be at every place, so that few lines must begin.
#pragma once

#include "surfpath/field/directions.hpp"

namespace filum::surfpath::field {

// Along an edge from vertex a to vertex b: the intended growth of the angle, and whether b counts it in the opposite
// direction.
struct EdgeGrowth {
    double growth = 0; // rad
    bool flipped = false;
};

// `along`: per vertex the direction of lines. `w`: per vertex the growth of the angle across the lines, in rad/mm.
EdgeGrowth edge_growth(const Surface& s, const Cells& cells, std::span<const Vec3> along, std::span<const double> w,
                       std::uint32_t a, std::uint32_t b);

// The direction of a triangle with the normal `n`: the mean of its corners' directions with the sign of the first;
// (0, 0, 0) if they cancel.
Vec3 mean_direction(const Cells& cells, std::span<const Vec3> along, const surface::Triangle& c, const Vec3& n);

// Per vertex the number of lines per spacing, from 1 / (1 + change) to 1 / (1 - change). Lines can be without a birth
// where the field of vectors across them, with this length, has no curl. The frequencies minimise the integral of the
// square of what the curl would be: frequency * (slope of its logarithm along the lines + curl of the unit vectors),
// without the first factor. Where the limits allow no more, births remain. All are 1 if `change` is 0.
std::vector<double> frequencies(const Surface& s, const Cells& cells, std::span<const Vec3> along, double change);

} // namespace filum::surfpath::field
