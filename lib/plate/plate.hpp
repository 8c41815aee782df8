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

// Where a thing goes: turned about (0, 0) by quarter turns to the left, then moved.
struct Place {
    Vec2 move;
    int quarters = 0; // 0 to 3

    [[nodiscard]] Vec2 operator()(Vec2 p) const {
        for (int k = 0; k < quarters; ++k) p = {-p.y, p.x};
        return p + move;
    }
    bool operator==(const Place&) const = default;
};

enum class Turn { none, all, each }; // all by one quarter turn, or each as finds room

// The place of each thing, so that they lie around (0, 0) within `size` of the bed, `apart` from each other; whole um.
// Where each may be turned by itself, they keep the greater distance in x and y.  Or the numbers of those that find no
// place (`left`), and no places.
struct Packed {
    std::vector<Place> place;
    std::vector<std::size_t> left;
};
Packed pack(std::span<const Thing> things, const Spacing& apart, Vec2 size, Turn turn = Turn::none);

} // namespace filum::plate
