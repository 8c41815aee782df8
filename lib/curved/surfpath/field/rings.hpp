// Rings as directions and as a phase of stripes: lines of equal distance from the rims, or from the sheet's sources on
// components without a rim.
#pragma once

#include "surface/curve/line.hpp"
#include "surfpath/field/directions.hpp"

namespace filum::surfpath::field {

struct RingField {
    // per vertex, mm, from the nearest rim; infinite on a component without rim and source
    std::vector<double> distance;
    // Per vertex the direction of its ring as a doubled angle, the mean over its triangles by area. On ridges of the
    // distance, where rings bend, triangles disagree, and its size is below 1.
    std::vector<Complex> z;
    std::vector<Vec3> along; // the same as a vector of any size, with the rim on its right
};

RingField ring_field(const surface::Sheet& sheet, const Cells& cells);

// The phase for which stripes along `along` are these rings, half a spacing from the rims and one spacing apart; 0
// where there is no rim.
std::vector<Complex> phase(const RingField& rings, std::span<const Vec3> along, double spacing);

// The rings themselves: lines of equal distance, half a spacing from the rims and one spacing apart. Where rings around
// several rims meet, they have corners.
std::vector<surface::curve::Line> whole_rings(const surface::Sheet& sheet, double spacing);

} // namespace filum::surfpath::field
