// Principal stresses of a tensor.
#pragma once

#include "stressfield/samples.hpp"

#include <optional>

namespace filum::stressfield {

struct PrincipalAxes {
    Principal values{}; // greatest first
    // unit, of the greatest; none if it is not unique: the next value equals it within 1e-6 of the one of the largest
    // magnitude
    std::optional<Vec3> first;
};

// Eigenvalues and the first eigenvector.
PrincipalAxes principal_axes(const Tensor& t);

// The direction in the plane perpendicular to the unit vector `n` with the greatest normal stress, if it is unique.
std::optional<Vec3> in_plane_axis(const Tensor& t, const Vec3& n);

// Of a direction and its opposite, the one with a positive component of largest magnitude; ties within 1e-9: the first
// component counts.
Vec3 signed_direction(const Vec3& d);

} // namespace filum::stressfield
