// The shape of the print head above the nozzle tip, which must not touch the part.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace filum::machine {

// A flat tip, a cone above it, a carriage box centred on the nozzle, and a gantry that spans the machine.
struct Head {
    double flat_radius = 0.2;               // mm, of the flat at the tip
    double cone_angle = 1.0471975511965976; // rad, the whole angle of the nozzle cone (60 degrees)
    double cone_height = 8;                 // mm from the tip to the underside of the carriage
    double carriage_x = 40;                 // mm, size of the carriage box
    double carriage_y = 40;                 // mm
    double gantry_height = std::numeric_limits<double>::infinity(); // mm; above it the head is infinitely wide
    bool none = false;                                              // no head at all: nothing ever collides

    // Radius of the nozzle `dz` mm above the tip, mm; above the cone it is that of the cone's wide end.
    [[nodiscard]] double cone_radius(double dz) const {
        return flat_radius + std::min(dz, cone_height) * std::tan(cone_angle / 2);
    }
};

// The user's choice of a head: a name, and sizes that replace those of the named head.  An empty list keeps a size.
struct HeadChoice {
    std::string name = "ordinary"; // or "none", or a machine profile's name or file
    std::vector<double> flat_radius, cone_angle_deg, cone_height, gantry_height; // mm, deg; gantry_height 0: no gantry
    std::vector<double> carriage;                                                // mm, x and y
};

// The head of a choice.  Throws as load_profile does.
Head head(const HeadChoice& choice);

// `from` with the sizes of the choice; the name of the choice is ignored.
Head altered(const Head& from, const HeadChoice& choice);

// A head that is larger on all sides: where it touches nothing, `head` keeps at least `distance` mm.
Head widened(const Head& head, double distance);

// A head as names and values of options that describe it completely.
struct HeadSetting {
    std::string name, value;
    bool changed = false; // the value differs from that of the ordinary head
};
std::vector<HeadSetting> settings(const Head& head);

} // namespace filum::machine
