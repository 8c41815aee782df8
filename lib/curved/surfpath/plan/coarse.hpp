// Plans on larger triangles where those of a surface are finer than its lines need.
#pragma once

#include "surface/curve/locate.hpp"
#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

#include <optional>

namespace filum::surfpath::plan {

// mm: the longest sides of the triangles to plan on in place of those of the surface, if lines need none shorter than
// `longest` and the surface has many more triangles than necessary: as many as equal sides of rules::kGrain of that
// would make, or more than rules::kMostPieces and kTwice as many as needed. In the second case sides are so long that
// about rules::kMostPieces triangles suffice, if that is longer.
std::optional<double> coarse_side(const Surface& surface, double longest);

inline constexpr double kTwice = 2; // a given triangle takes less time to replace than another one to plan on

// The surface and the fields of a sheet with sides of at most about `side` mm, shorter where it bends: its chords are
// within `tolerance` mm of the given surface. Vertices and triangles must be sorted by place (plan/refined.hpp), so
// that equal surfaces get equal results.
surface::Sheet coarser(const surface::Sheet& sheet, const surface::curve::Locator& locator, double side,
                       double tolerance);

// Moves the plan of the coarse surface to the nearest places of the given one that face the same way.
void to_given(Plan& plan, const Surface& coarse, const surface::curve::Locator& given);

} // namespace filum::surfpath::plan
