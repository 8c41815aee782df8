// The proxy of a patch: its mean normal and its mean direction.
#pragma once

#include "partition/cells.hpp"

namespace filum::partition {

// Sums over cells. The spread of a patch is the amount by which they fall short of the plain sums.
struct Proxy {
    double area = 0;   // mm2
    Vec3 facing{};     // sum of the normals weighted by area
    double weight = 0; // sum of area times trust
    Vec3 along{};      // unit, perpendicular to the mean normal, without sign; (0, 0, 0): unknown
    double agreed = 0; // sum of weight times cos(2 angle) relative to `along`

    [[nodiscard]] Vec3 normal() const; // unit
    // mm2: the integral of 1 - cos(angle of the normal from the mean), plus that of weight times 1 - cos(2 angle of
    // the direction).
    [[nodiscard]] double spread() const { return area - norm(facing) + weight - agreed; }
};

// False if the normals with the small piece would be spread more than those of half a tube, so that a ring could
// close. Arguments are the sums of normals weighted by area.
bool may_take(const Vec3& facing, double area, const Vec3& small, double small_area);

Proxy proxy(const Cells& cells, const Pull& pull, std::size_t vertex);

// The proxy of both together. Mean directions are compared after rotation into the common plane.
Proxy joined(const Proxy& a, const Proxy& b);

// rad, 0 to pi/2: angle between the cell's direction, rotated into the proxy's plane, and the proxy's direction; 0 if
// either is unknown.
double angle_from(const Proxy& p, const Vec3& normal, const Vec3& along);

// rad, 0 to pi: angle between the cell's normal and the proxy's.
double bend_from(const Proxy& p, const Vec3& normal);

// Per mm2, the contribution of the cell to the spread of a patch with a fixed proxy.
double misfit(const Proxy& p, const Cells& cells, const Pull& pull, std::size_t vertex);

} // namespace filum::partition
