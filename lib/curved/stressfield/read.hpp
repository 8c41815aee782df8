// Readers of stresses: CSV, CalculiX .frd, VTK .vtu; each also compressed by gzip.
#pragma once

#include "base/note.hpp"
#include "stressfield/samples.hpp"

#include <string_view>

namespace filum::stressfield {

struct ReadOptions {
    std::string columns = {};         // CSV: roles of the columns, in order; VTU: arrays to read; "": by names
    std::string names = {};           // of the load cases, separated by commas; "": those of the file
    std::string step = "all";         // FRD: a result by its name, see frd.cpp, or "all"
    std::string unit = "auto";        // of positions: mm, cm, m, in; auto: as in the file, otherwise mm
    std::string stress_unit = "auto"; // MPa, Pa, kPa, GPa, psi, ksi; auto: as in the file, otherwise MPa
    std::string order = {};           // VTU: order of the components of tensors; "": by their names, otherwise VTK's
    std::string decimal = "auto";     // CSV: point, comma; auto: by the numbers
};

// The stresses in `bytes`, the complete content of a file, whose format is recognised by its content. `name` is for
// messages. All points are finite and all indices in range; there is at least one case, and every case has a unique
// name of letters, digits, '-' and '_'. Throws Error: truncated if the file ends too early; bad_input if its format is
// unknown, it is malformed, or has no stresses; usage if the options do not suit it.
Samples read(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes);

} // namespace filum::stressfield
