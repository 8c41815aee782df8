// Isocontours of a field that is linear on triangles, level by level.
#pragma once

#include "base/note.hpp"
#include "surface/sheet.hpp"

#include <span>
#include <vector>

namespace filum::baselines::kipping2022 {

using geom::Vec3;
using surface::Surface;

using Points = std::vector<Vec3>;

// Steps: a value this near to a level is at it; otherwise lines along rims would fall into small pieces.
inline constexpr double kAtLevel = 1e-6;

double length(std::span<const Vec3> points, bool closed);

// One piece of an isocontour, with smaller values on its left, seen from the side that the surface faces.
struct Contour {
    std::uint32_t level = 0; // i, of i d
    bool closed = false;
    Points points;              // neighbours are more than 1e-9 mm apart; the first is not repeated
    std::uint32_t triangle = 0; // in which it begins
};

// The isocontours c_1, c_2, ... of `values` (per vertex; none through infinite ones) at levels `step` apart: c_i at
// index i - 1, up to the last level that is below the greatest value by more than rounding. Pieces shorter than
// `least` mm are left out with a note.
// Throws Error(usage) for more than 100000 levels.
std::vector<std::vector<Contour>> contours(const Surface& s, std::span<const double> values, double step, double least,
                                           Notes& notes);

// The sheet's field "distance".
// Throws Error(bad_input) if there is none; `need` ends the message, as "run geodesic --source boundary first".
const std::vector<double>& distances(const surface::Sheet& sheet, const char* need);

// Adds a note with the area of components that the field does not reach.
void note_unreached(const Surface& s, std::span<const double> values, Notes& notes);

// A note about `mm` of lines around `at`.
Note lines_note(NoteCode code, double mm, const Vec3& at);

} // namespace filum::baselines::kipping2022
