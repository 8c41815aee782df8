// Beads that rise from one layer to the next.
#pragma once

#include "link3d/bead.hpp"

namespace filum::link3d {

inline constexpr double kFaint = 0.05; // of the layer's height: the thin end of a ramp; flow never stops

// A ramp (scarf joint): the first `length` mm of a path rise to the layer's height; `lead` mm of these come before the
// bead begins. The last length - lead mm of the bead overlap its beginning and add the material that is missing there.
struct Ramp {
    double length = 0, lead = 0; // mm; no ramp if the length is 0
    double from = 0;             // mm, z at the beginning
};

// The bead at height z, `height` mm thick. On a ramp it rises or gets thinner, and its points are at most `step` mm
// apart.
struct SpatialBead {
    std::vector<geom::Vec3> points;
    std::vector<double> width, height; // mm, per point, or one for all
};
SpatialBead lay(const Bead& bead, double z, double height, const Ramp& ramp, double step);

} // namespace filum::link3d
