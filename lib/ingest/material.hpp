// How much material the extruder word of a program means.
#pragma once

#include "ingest/remarks.hpp"
#include "machine/profile.hpp"

namespace filum::ingest {

// mm3 of one unit of the extruder word.  `filament`: mm, its diameter if it is given, else 0; `volumetric`: the program
// counts mm3.
double unit_volume(const machine::Profile& profile, std::uint32_t tool, double filament, const Told& told,
                   bool volumetric);

} // namespace filum::ingest
