// Several parts side by side on one bed.
#pragma once

#include "geom/vec.hpp"
#include "machine/head.hpp"

#include <optional>
#include <span>
#include <vector>

namespace filum::plate {

using geom::Vec2;

// What is to stand on the bed.
struct Thing {
    std::vector<Vec2> outline; // its convex hull seen from above, counter-clockwise, mm
    double height = 0;         // mm, from the bed to its top
};

// How far parts keep from each other: along x or along y, edge to edge, mm.
struct Spacing {
    double x = 0, y = 0;
    bool clear = false; // the head passes between any two of them, so that each can be printed to its top by itself
};

// The spacings to try, widest first: the head as wide as it is below the top of the second highest part (it only meets
// the lower one of two, as the higher one can be printed first); then its nozzle alone, so that parts grow together.
// A head that spans the machine below that top, or none at all, leaves the second only.
std::vector<Spacing> spacings(std::span<const Thing> things, const machine::Head& head);
// The one that was asked for.
Spacing spacing(double apart, std::span<const Thing> things, const machine::Head& head);

// How far each thing is moved, so that they lie around (0, 0) within `size` of the bed, `apart` from each other,
// unturned; whole um.  Or the numbers of those that find no place (`left`), and no moves.
struct Packed {
    std::vector<Vec2> move;
    std::vector<std::size_t> left;
};
Packed pack(std::span<const Thing> things, const Spacing& apart, Vec2 size);

} // namespace filum::plate
