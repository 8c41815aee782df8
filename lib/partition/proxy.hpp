// What cells have in common: a mean normal and a mean direction.
#pragma once

#include "partition/cells.hpp"

namespace filum::partition {

// Sums over cells, to which more can be added; a patch is as incoherent as they fall short of the plain sums.
struct Proxy {
    double area = 0;   // mm2
    Vec3 facing{};     // sum of normals, by area
    double weight = 0; // sum of area times trust
    Vec3 along{};      // unit, in the plane across the mean normal, without a sign; (0, 0, 0): not known
    double agreed = 0; // of the weight what adds up along it: sum of weight times cos(2 angle)

    [[nodiscard]] Vec3 normal() const; // unit
    // mm2: area times 1 - cos of the normals' angles from the mean, and weight times 1 - cos of twice the directions'.
    [[nodiscard]] double spread() const { return area - norm(facing) + weight - agreed; }
};

// False if something small would make normals more spread than those of half a tube, so that a ring might close; given
// the sums of normals, by area.
bool may_take(const Vec3& facing, double area, const Vec3& small, double small_area);

Proxy proxy(const Cells& cells, const Pull& pull, std::size_t vertex);

// Both together; the mean directions compare after turning their planes into the common one.
Proxy joined(const Proxy& a, const Proxy& b);

// rad, 0 to pi/2: between the cell's direction, turned into the proxy's plane, and the proxy's; 0 if one is not known.
double angle_from(const Proxy& p, const Vec3& normal, const Vec3& along);

// rad, 0 to pi: between the cell's normal and the proxy's.
double bend_from(const Proxy& p, const Vec3& normal);

// Per mm2, what the cell adds to the spread of a patch whose proxy stays as it is.
double misfit(const Proxy& p, const Cells& cells, const Pull& pull, std::size_t vertex);

} // namespace filum::partition
