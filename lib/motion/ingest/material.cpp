#include "ingest/material.hpp"

#include <algorithm>
#include <numbers>

namespace filum::ingest {

double unit_volume(const machine::Profile& profile, std::uint32_t tool, double filament, const ProgramTraits& traits,
                   bool volumetric) {
    constexpr double kUsualDiameter = 1.75; // mm
    const auto& e = machine::of_tool(profile, tool).extrusion;
    if (volumetric || traits.volumetric) return 1;
    const bool known = !profile.name.empty();
    if (known && e.feeding != machine::Feeding::filament) return 1 / e.per_mm3();
    double d = filament;
    if (!(d > 0) && !traits.diameters.empty())
        d = traits.diameters[std::min<std::size_t>(tool, traits.diameters.size() - 1)];
    if (!(d > 0) && known) return 1 / e.per_mm3();
    if (!(d > 0)) d = kUsualDiameter;
    return std::numbers::pi * d * d / 4;
}

} // namespace filum::ingest
