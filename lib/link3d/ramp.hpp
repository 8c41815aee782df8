// Beads that rise from one layer to the next.
#pragma once

#include "link3d/bead.hpp"

namespace filum::link3d {

inline constexpr double kFaint = 0.05; // of the layer's height: what a ramp begins and ends with; flow never stops

// A scarf: the first `length` mm of a way rise to the layer's height, `lead` mm of them before the bead begins; the
// bead's last length - lead mm lie over its first ones and lay what is missing there.
struct Ramp {
    double length = 0, lead = 0; // mm; no ramp if the length is 0
    double from = 0;             // mm, z where it begins
};

// The bead at z, as thick as `height` but on a ramp.  Where it is on one, points are at most `step` mm apart.
struct Laid {
    std::vector<geom::Vec3> points;
    std::vector<double> width, height; // mm, per point, or one for all
};
Laid lay(const Bead& bead, double z, double height, const Ramp& ramp, double step);

} // namespace filum::link3d
