// Which head to keep clear of, as the user says it.
#pragma once

#include "machine/head.hpp"

#include <string>
#include <utility>
#include <vector>

namespace filum::sequence {

// A head by name, and what is to be different about it; empty lists leave it as it is.
struct HeadChoice {
    std::string name = "ordinary"; // or "none", or a machine profile's name or file
    std::vector<double> flat_radius, cone_angle_deg, cone_height, gantry_height; // mm, deg; gantry 0: out of reach
    std::vector<double> carriage;                                                // mm, x and y
};

// Throws Error like machine::load_profile.
machine::Head head(const HeadChoice& choice);

// The head, wherever it came from, as names and values of options that give it again.
std::vector<std::pair<std::string, std::string>> settings(const machine::Head& head);

} // namespace filum::sequence
