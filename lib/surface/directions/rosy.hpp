// Directions without a sign, as complex numbers: lines, not arrows (2-RoSy fields).
#pragma once

#include "sparse/factor.hpp"
#include "surface/directions/cells.hpp"

#include <complex>
#include <optional>
#include <span>

namespace filum::surface::directions {

using Complex = std::complex<double>;

// Some vector across `n` as its angle from across(n), doubled; its length squared.
Complex doubled(const Vec3& d, const Vec3& n);

// A unit vector across `n` of which `z` is the doubled angle; either of the two.  (0, 0, 0) if z is 0.
Vec3 direction(const Complex& z, const Vec3& n);

// What turns a number at a vertex of normal `a` into that of the same direction at one of normal `b`, the one plane
// turned into the other by the least rotation.
Complex transport(const Vec3& a, const Vec3& b);

// Directions made smooth, as often as weights change: the order of the unknowns is found once.
class Smoother {
  public:
    Smoother(const Cells& cells, double length) : cells_(cells), length_(length) {}

    // The z with the least sum over area of weight |z - given|^2 + length^2 |grad z|^2, neighbours compared after
    // transport.  Where no weight is near, z is small.  (After Knoppel, Crane, Pinkall, Schroeder 2013, "Globally
    // optimal direction fields", with a data term.)  Throws Error(failure) if the triangles are too uneven.
    std::vector<Complex> smoothed(std::span<const Complex> given, std::span<const double> weight);

  private:
    const Cells& cells_;
    double length_; // mm
    std::optional<sparse::Factor> factor_;
};

} // namespace filum::surface::directions
