// What is printed against what the mesh holds: no layer and no volume goes without a word.
#pragma once

#include "slice/slice.hpp"

#include <optional>
#include <span>

namespace filum::slice {

// How much of a part is solid, found another way than by slicing it: planes of its own, two or more in each layer that
// is asked.  Where contours close, the area that they wind round, by rows; where they don't, points at which the
// surface winds round by more than one half.  Undecided is what it winds round by a quarter more or less than a whole
// number, or less than not at all.
struct Measured {
    std::vector<std::size_t> layers;      // that were asked, ascending; all of them if there are not many
    std::vector<double> solid, undecided; // of each, mm3
    std::vector<geom::Vec2> where;        // of each, somewhere undecided
    double baseless = 0;                  // mm3 that are undecided even if triangles missing all over are allowed for
};
Measured measure(const Sweep& sweep, std::size_t planes, std::size_t points, int threads);

// For a mesh that is not closed: measures it, and notes what it leaves undecided, if that is more than 2 % of the
// solid, and what its holes may have lost.  Throws Error(bad_input) if more is undecided than solid: random triangles,
// a sheet.  Nothing for a closed mesh.
std::optional<Measured> judge(const Sweep& sweep, int threads, Notes& notes);

// Notes a printed volume that is more than 2 % off, with the layer where most is, and empty layers between others.
// `area` is that of each layer, mm2; `measured` what judge() gave.  A closed mesh is measured only if the sum of its
// shells' volumes does not say enough.
void compare(const Sweep& sweep, const std::optional<Measured>& measured, std::span<const double> area, int threads,
             Notes& notes);

} // namespace filum::slice
