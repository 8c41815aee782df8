// Isocontours of a field that is linear in triangles, level by level.
#pragma once

#include "base/note.hpp"
#include "surface/sheet.hpp"

#include <span>
#include <vector>

namespace filum::baselines::kipping2022 {

using geom::Vec3;
using surface::Surface;

using Points = std::vector<Vec3>;

// Of a step: a value so near a level has it, or lines along rims would come in crumbs.
inline constexpr double kAtLevel = 1e-6;

double length(std::span<const Vec3> points, bool closed);

// One piece of a level.  What is less lies to its left, seen from the side that the surface faces.
struct Contour {
    std::uint32_t level = 0; // i, of i d
    bool closed = false;
    Points points;              // no two neighbours within 1e-9 mm; the first is not repeated
    std::uint32_t triangle = 0; // that it begins in
};

// c_1, c_2, ... of `values` (per vertex; infinite ones have none), levels `step` apart: c_i at index i - 1, up to the
// last that is below the greatest value by more than rounding.  Pieces shorter than `least` mm are left out and noted.
// Throws Error(usage) for more than 100000 levels.
std::vector<std::vector<Contour>> contours(const Surface& s, std::span<const double> values, double step, double least,
                                           Notes& notes);

// The sheet's field "distance".
// Throws Error(bad_input) if it has none: `need` ends the message, "run geodesic --source boundary first".
const std::vector<double>& distances(const surface::Sheet& sheet, const char* need);

// Notes the area of components that the field does not reach.
void note_unreached(const Surface& s, std::span<const double> values, Notes& notes);

// A note of `mm` of lines around `at`.
Note lines_note(NoteCode code, double mm, const Vec3& at);

} // namespace filum::baselines::kipping2022
