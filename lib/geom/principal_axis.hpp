// The direction in which points are spread most, and where it leaves an outline (principal component analysis).
#pragma once

#include "geom/vec.hpp"

#include <optional>
#include <span>

namespace filum::geom {

struct Axis {
    Vec2 mean;
    Vec2 direction; // unit; towards +x, or +y if upright to a millionth
};

// The axis of greatest variance of `points`, at least one; along x where all directions are alike.
Axis principal_axis(std::span<const Vec2> points);

// Of the places where the axis crosses the closed line through `points`, the one farthest along it; nothing if it
// crosses none.  Tie: the first.
std::optional<Vec2> leaves(const Axis& axis, std::span<const Vec2> points);

} // namespace filum::geom
