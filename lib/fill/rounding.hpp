// Corners of a bead rounded off.  Private to lib/fill.
#pragma once

#include "toolpath/path.hpp"

#include <functional>
#include <limits>

namespace filum::fill {

using geom::Vec2;

enum class Rounded { nowhere, inside, everywhere }; // inside: but for corners of beads along the outline

struct Corners {
    double open;      // mm2 that a rounded right angle leaves beyond it, at most
    double tolerance; // mm: what beads' edges may be off
    Rounded round = Rounded::everywhere;
    // mm2 that all of a line's corners leave: where they would leave more, each has its share of it
    double open_in_all = std::numeric_limits<double>::infinity();
};

// The closed line with each corner rounded off: its points moved to the mean of what lies within a reach of them along
// the line, which makes a right angle a parabola that leaves `open` mm2 beyond it; beads narrower than `width` have
// less reach.  A corner is where that moves the line by more than half of what it may be off (rings::kMostOff); along
// the outline it moves it by no more than that.  Straight and gently bent stretches stay as they are, and parallel
// corners stay parallel. What the bead loses in length it gains in width, as far as a machine follows and not past the
// room it has: room(p) is the distance from p to the region's outline, or anything larger than a bead.  A line stays as
// it is if it is so short that the reaches of a square's corners would meet.  May cross itself where it came nearer to
// itself than the reach.
toolpath::Curve rounded(const toolpath::Curve& line, double width, const Corners& how,
                        const std::function<double(Vec2)>& room);

} // namespace filum::fill
