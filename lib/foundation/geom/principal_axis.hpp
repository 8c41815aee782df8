// The direction in which points are spread most (principal component analysis), and where it leaves an outline.
#pragma once

#include "geom/vec.hpp"

#include <optional>
#include <span>

namespace filum::geom {

struct Axis {
    Vec2 mean;
    Vec2 direction; // unit; towards +x, or towards +y if vertical within 1e-6
};

// The axis of greatest variance of at least one point; along x if the variance is equal in all directions.
Axis principal_axis(std::span<const Vec2> points);

// The crossing of the axis with the closed line through `points` that is farthest along the axis; none if there is no
// crossing. Ties: the first.
std::optional<Vec2> leaves(const Axis& axis, std::span<const Vec2> points);

} // namespace filum::geom
