// The lines of equal distance from the rims, as directions and as stripes; on components without a rim, from the
// sources of the sheet.
#pragma once

#include "surfpath/field/directions.hpp"

namespace filum::surfpath::field {

struct Rings {
    std::vector<double> distance; // per vertex, mm, of the nearest rim; infinite on a component without one
    // Per vertex along its ring, as a doubled angle: the mean of its triangles', by area.  On ridges of the distance,
    // where rings bend, triangles disagree, and its size is below 1.
    std::vector<Complex> z;
    std::vector<Vec3> along; // likewise, with the rim to the right; of any size
};

Rings rings(const surface::Sheet& sheet, const Cells& cells);

// The phase by which stripes along `along` are these rings, half a spacing from the rims and one apart; 0 where there
// is no rim.
std::vector<Complex> phase(const Rings& rings, std::span<const Vec3> along, double spacing);

} // namespace filum::surfpath::field
