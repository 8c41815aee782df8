// Places several parts side by side on one bed.
#pragma once

#include "geom/vec.hpp"
#include "machine/head.hpp"

#include <optional>
#include <span>
#include <vector>

namespace filum::plate {

using geom::Vec2;

// A part to be placed on the bed.
struct Thing {
    std::vector<Vec2> outline; // its convex hull seen from above, counter-clockwise, mm
    double height = 0;         // mm, from the bed to its top
};

// The least distance between parts along x or along y, edge to edge, mm. It holds if it is kept along one of the two.
struct Spacing {
    double x = 0, y = 0;
    bool clear = false; // the head passes between any two of them, so that each can be printed to its top by itself
};

// The spacings to try, widest first. The first one clears the head as wide as it is below the top of the second highest
// part. The highest part can be printed last, so the head meets only the lower of any two. The second one clears only
// the nozzle, so that parts grow together. If the head spans the machine below that top, only the second one is left.
// Without a head, only the first one is left.
std::vector<Spacing> spacings(std::span<const Thing> things, const machine::Head& head);
// The spacing for a requested distance `apart`, mm.
Spacing spacing(double apart, std::span<const Thing> things, const machine::Head& head);

// The place of a part: it is turned about (0, 0) by quarter turns to the left, then moved by `move` mm.
struct Place {
    Vec2 move;
    int quarters = 0; // 0 to 3

    [[nodiscard]] Vec2 operator()(Vec2 p) const {
        for (int k = 0; k < quarters; ++k) p = {-p.y, p.x};
        return p + move;
    }
    bool operator==(const Place&) const = default;
};

enum class QuarterTurns { none, all, each }; // all: every part by one quarter turn; each: every part as it fits best

// Places all parts around (0, 0) within `size` of the bed, `apart` from each other. Places are rounded to whole um.
// With QuarterTurns::each, the larger of the two distances applies in x and y. If some parts do not fit, `left` holds
// their indices and `place` is empty.
struct Packing {
    std::vector<Place> place;
    std::vector<std::size_t> left;
};
Packing pack(std::span<const Thing> things, const Spacing& apart, Vec2 size, QuarterTurns turn = QuarterTurns::none);

} // namespace filum::plate
