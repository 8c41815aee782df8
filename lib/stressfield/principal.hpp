// Principal stresses of a tensor.
#pragma once

#include "stressfield/samples.hpp"

#include <optional>

namespace filum::stressfield {

struct Axes {
    Principal values{};        // greatest first
    std::optional<Vec3> first; // unit, of the greatest; none where that is no direction: the next is equal to 1e-6 of
                               // the largest in size
};

// Eigenvalues and the first eigenvector.
Axes principal_axes(const Tensor& t);

// The direction in the plane across the unit vector `n` along which normal stress is greatest, if one is.
std::optional<Vec3> in_plane_axis(const Tensor& t, const Vec3& n);

// Of a direction and its opposite, the one whose component of largest size is positive; of components equal in size to
// 1e-9, the first counts.
Vec3 signed_direction(const Vec3& d);

} // namespace filum::stressfield
