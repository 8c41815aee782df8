// Rounds the corners of beads. Private to lib/planar/fill.
#pragma once

#include "toolpath/path.hpp"

#include <functional>
#include <limits>

namespace filum::fill {

using geom::Vec2;

// The distance of a point from the outline of its region, or the second number (mm) if that is less.
using Room = std::function<double(Vec2, double)>;

enum class Rounded { nowhere, inside, everywhere }; // inside: all corners except those along the outline

struct Corners {
    double open;      // mm2 of void beyond a rounded right angle, at most
    double tolerance; // mm: tolerance of bead edges
    Rounded round = Rounded::everywhere;
    // mm2 of void at all corners of a line together. If they would leave more, each gets an equal share of it.
    double open_in_all = std::numeric_limits<double>::infinity();
    // mm of line for each right angle of its corners, from which all corners stay sharp: rounding them would save a
    // machine less than a hundredth of its time.
    double rare = std::numeric_limits<double>::infinity();
};

// Rounds the corners of a closed line. Each point near a corner moves to the mean of the line within a reach of it. A
// right angle becomes a parabola that leaves `open` mm2 beyond it. Beads narrower than `width` have a smaller reach.
//
// A point is a corner if it would move by more than half of the allowed offset (rings::kMostOff). Along the outline no
// corner moves by more than that offset. Straight and gently bent stretches stay as they are, and parallel corners stay
// parallel.
//
// The bead gets wider where it gets shorter, up to what a machine can follow, to twice the `width` and to the room that
// it has.
//
// Corners stay sharp where they are rare (`Corners::rare`). A line also stays as it is if the reaches of a square's
// corners would meet on a line of its length. The result may cross itself where the line came nearer to itself than the
// reach.
toolpath::Curve rounded(const toolpath::Curve& line, double width, const Corners& how, const Room& room);

} // namespace filum::fill
