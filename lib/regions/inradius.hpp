// How wide an area is at its widest.
#pragma once

#include "polygon/loops.hpp"

namespace filum::regions {

// A radius, mm, such that a circle of it certainly fits into the simple area: at least `enough`, or else within a
// factor of two of the largest, or 0 if the largest is below `least`. An area A of perimeter P with k holes has A <= P
// r + k pi r^2 for its inradius r (Sz.-Nagy 1959), which settles most cases without any geometry; the others are
// eroded.
double inradius_bound(const polygon::Loops& area, double enough, double least);

} // namespace filum::regions
