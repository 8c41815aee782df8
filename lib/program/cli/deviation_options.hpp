// Options that say how far a program for a machine may deviate from the toolpath.
#pragma once

#include "cli/spec.hpp"

#include <vector>

namespace filum::cli {

// The options, bound to the fields of `to`, a postproc::Options.
template <class Deviations>
std::vector<Option> deviation_options(Deviations& to) {
    return {
        Option{"path-tolerance", &to.path_tolerance, "MM",
               "moves are merged as long as the path stays that near; 0: only those below 0.001 mm; left out: 0.01, "
               "on surfaces 0.02"}
            .at_least(0)
            .at_most(10)
            .numbers(1),
        Option{"axis-tolerance", &to.axis_tolerance, "DEG",
               "the same for the tool's axis, on machines with rotary axes; default: 0.5"}
            .at_least(0)
            .at_most(45)
            .numbers(1),
        {"flatten", &to.flatten, "", "lets an upright nozzle follow a path that leans the tool"},
        Option{"short", &to.short_strokes, "", "fibre strokes below fibre.least_path are an error, or dropped"}.one_of(
            {"error", "drop"})};
}

} // namespace filum::cli
