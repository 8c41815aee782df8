// The print head's shape above the nozzle tip: what must not touch the part while it grows.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

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

// A head as the user says it: by name, and what is to be different about it; empty lists leave it as it is.
struct HeadChoice {
    std::string name = "ordinary"; // or "none", or a machine profile's name or file
    std::vector<double> flat_radius, cone_angle_deg, cone_height, gantry_height; // mm, deg; gantry 0: out of reach
    std::vector<double> carriage;                                                // mm, x and y
};

// Throws Error like load_profile.
Head head(const HeadChoice& choice);

// `from` with what the choice has different about it, whatever its name.
Head altered(const Head& from, const HeadChoice& choice);

// The head, wherever it came from, as names and values of options that give it again.
struct HeadSetting {
    std::string name, value;
    bool changed = false; // differs from the ordinary head's
};
std::vector<HeadSetting> settings(const Head& head);

} // namespace filum::machine
