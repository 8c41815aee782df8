// Options of commands that read STEP files.
#pragma once

#include "cli/command.hpp"

#include <vector>

namespace filum::cli {

// The options, bound to the fields of `to`, a mesh::step::Tessellation.
template <class Tessellation>
std::vector<Option> step_options(Tessellation& to) {
    return {Option{"deflection", &to.deflection, "MM", "STEP: largest distance between triangles and CAD faces"}
                .at_least(0.0001)
                .at_most(1000),
            Option{"deflection-angle", &to.angle_deg, "DEG", "STEP: largest angle between two chords of a curve"}
                .at_least(0.1)
                .at_most(90)};
}

// Warns about these options if they were given and no input file is STEP.
inline void step_idle(const Io& io, bool is_step) {
    if (is_step) return;
    for (const char* name : {"deflection", "deflection-angle"}) io.idle(name, "no file is STEP");
}

} // namespace filum::cli
