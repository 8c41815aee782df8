// Bridges: skins over air. Private to lib/planar/skins.
#pragma once

#include "skins/skins.hpp"

namespace filum::skins {

// Finds the bridges of a layer in `within`, the area inside the walls of a region. A bridge is a connected piece of
// `within` that has no material below it and is somewhere wider than Options::bridge.
//
// Returns one area for each bridge, with the direction of its lines in rad. Among 36 directions, 5 degrees apart, it is
// the one whose longest carried line is the shortest. Only directions count in which the lines with a loose end are at
// most one line longer than the least possible. Ties: the smaller angle.
//
// A piece is no bridge if in every direction more than half of the line length has a loose end: it hangs from one side.
std::vector<polygon::Area> bridges(const polygon::Loops& within, const polygon::Loops& below, const Options& options);

} // namespace filum::skins
