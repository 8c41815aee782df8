// Directions without sign as complex numbers: lines rather than arrows (2-RoSy fields).
#pragma once

#include "sparse/factor.hpp"
#include "surface/directions/cells.hpp"

#include <complex>
#include <optional>
#include <span>

namespace filum::surface::directions {

using Complex = std::complex<double>;

// The doubled angle of a vector perpendicular to `n`, measured from across(n); its absolute value is the squared
// length.
Complex doubled(const Vec3& d, const Vec3& n);

// A unit vector perpendicular to `n` with the doubled angle `z`; either of the two. (0, 0, 0) if z is 0.
Vec3 direction(const Complex& z, const Vec3& n);

// The factor that converts a number at a vertex of normal `a` to that of the same direction at one of normal `b`,
// under the least rotation between the tangent planes.
Complex transport(const Vec3& a, const Vec3& b);

// Smooths directions repeatedly with changing weights; the order of the unknowns is computed once.
class Smoother {
  public:
    Smoother(const Cells& cells, double length) : cells_(cells), length_(length) {}

    // The z that minimises the integral of weight |z - given|^2 + length^2 |grad z|^2; neighbours are compared after
    // transport. Far from any weight, z is small. (Knoppel, Crane, Pinkall, Schroeder 2013, "Globally optimal
    // direction fields", with a data term.) Throws Error(failure) if the triangles are too uneven.
    std::vector<Complex> smoothed(std::span<const Complex> given, std::span<const double> weight);

  private:
    const Cells& cells_;
    double length_; // mm
    std::optional<sparse::Factor> factor_;
};

} // namespace filum::surface::directions
