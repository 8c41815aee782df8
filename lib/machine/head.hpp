// The print head's shape above the nozzle tip: what must not touch the part while it grows.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::machine {

// A flat tip, a cone above it, then a carriage box centred on the nozzle, then a gantry that spans the machine.
struct Head {
    double flat_radius = 0.2;               // mm, of the flat at the tip
    double cone_angle = 1.0471975511965976; // rad, the whole angle of the nozzle cone (60 degrees)
    double cone_height = 8;                 // mm from the tip to the underside of the carriage
    double carriage_x = 40;                 // mm, size of the carriage box
    double carriage_y = 40;                 // mm
    double gantry_height = std::numeric_limits<double>::infinity(); // mm; above it the head is infinitely wide
    bool none = false;                                              // no head at all: nothing ever collides

    // Radius of the nozzle `dz` mm above the tip; above the cone, that of its wide end.
    [[nodiscard]] double cone_radius(double dz) const {
        return flat_radius + std::min(dz, cone_height) * std::tan(cone_angle / 2);
    }
};

} // namespace filum::machine
