// Options of commands that avoid collisions with a print head.
#pragma once

#include "cli/spec.hpp"

#include <vector>

namespace filum::cli {

// The options, bound to the fields of `to`, a machine::HeadChoice. None of them is a setting, because commands record
// the resulting head instead.
template <class HeadChoice>
std::vector<Option> head_options(HeadChoice& to) {
    const auto length = [](const char* name, std::vector<double>& at, const char* unit, const char* help) {
        return Option{name, &at, unit, help}.within(0, 1e4).numbers(1).not_a_setting().when("!head=none").a_limit();
    };
    return {
        Option{"head", &to.name, "HEAD", "ordinary, none, or the head of a machine profile: its name or file"}
            .not_a_setting()
            .a_limit(),
        length("flat-radius", to.flat_radius, "MM", "radius of the flat at the tip; the ordinary head's is 0.2"),
        length("cone-angle", to.cone_angle_deg, "DEG", "whole angle of the nozzle's cone; ordinary 60").at_most(175),
        length("cone-height", to.cone_height, "MM", "height of the carriage above the tip; ordinary 8"),
        length("carriage", to.carriage, "MM,MM", "size of the carriage around the nozzle; ordinary 40,40").numbers(2),
        length("gantry-height", to.gantry_height, "MM",
               "height of the gantry above the tip, 0 for out of reach; ordinary 0")};
}

// The group of these options in the help.
inline Group head_group() {
    return {"the print head", {"head", "flat-radius", "cone-angle", "cone-height", "carriage", "gantry-height"}};
}

} // namespace filum::cli
