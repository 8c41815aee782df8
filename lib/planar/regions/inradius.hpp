// Estimates how wide an area is at its widest.
#pragma once

#include "polygon/loops.hpp"

namespace filum::regions {

// A radius, mm, of a circle that certainly fits into the simple area. It is at least `enough`, or else within a factor
// of two of the largest; 0 if the largest is below `least`. An area A of perimeter P with k holes and inradius r has A
// <= P r + k pi r^2 (Sz.-Nagy 1959). That settles most cases without any geometry; the others are eroded.
double inradius_bound(const polygon::Loops& area, double enough, double least);

} // namespace filum::regions
