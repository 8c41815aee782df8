// The volume of material that the extruder word of a program stands for.
#pragma once

#include "ingest/remarks.hpp"
#include "machine/profile.hpp"

namespace filum::ingest {

// The volume of one unit of the extruder word, mm3. `filament`: its diameter in mm, or 0 if it is not given.
// `volumetric`: the program counts mm3.
double unit_volume(const machine::Profile& profile, std::uint32_t tool, double filament, const ProgramTraits& traits,
                   bool volumetric);

} // namespace filum::ingest
