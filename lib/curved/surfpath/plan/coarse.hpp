// Plans on larger triangles where those of a surface are finer than its lines need.
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

#include <optional>

namespace filum::surfpath::plan {

// The surface and the fields of a sheet with sides of about `longest` mm, shorter where it bends: its chords are within
// `tolerance` mm of the given surface. None if the given triangles are not much smaller: fewer than kMuchFiner times as
// many as equal sides of `longest` mm would make. Vertices and triangles must be sorted by place (plan/refined.hpp), so
// that equal surfaces get equal results.
std::optional<surface::Sheet> coarser(const surface::Sheet& sheet, double longest, double tolerance);

inline constexpr double kMuchFiner = 16; // sides of a quarter

// Moves the plan of the coarse surface to the nearest places of the given one that face the same way.
void to_given(Plan& plan, const Surface& coarse, const Surface& given);

} // namespace filum::surfpath::plan
