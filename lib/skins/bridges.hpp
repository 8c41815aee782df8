// Skins over air.  Private to lib/skins.
#pragma once

#include "skins/skins.hpp"

namespace filum::skins {

// What of `within`, the inside of a region's walls, spans more than Options::bridge over what has nothing below it,
// from material to material of the layer below: an area for each connected piece, with the direction in which the
// longest line is the shortest, of those in which least of its lines ends in the air (but for the length of one). Found
// to 5 degrees; ties: the smaller angle.  A piece most of whose lines end in the air in all directions is no bridge: it
// hangs from one side.
std::vector<polygon::Area> bridges(const polygon::Loops& within, const polygon::Loops& below, const Options& options);

} // namespace filum::skins
