// Reading stresses: CSV, CalculiX .frd, VTK .vtu, each also compressed by gzip.
#pragma once

#include "base/note.hpp"
#include "stressfield/samples.hpp"

#include <string_view>

namespace filum::stressfield {

struct ReadOptions {
    std::string columns = {};  // of a CSV its columns by role, in order; of a VTU the arrays to read; "": by names
    std::string names = {};    // of the cases, between commas; "": the file's own
    std::string step = "all";  // of an FRD: a result by its name, see frd.cpp, or "all"
    std::string unit = "auto"; // of positions: mm, cm, m, in; auto: as the file says, else mm
    std::string stress_unit = "auto"; // MPa, Pa, kPa, GPa, psi, ksi; auto: as the file says, else MPa
    std::string order = {};           // of the numbers of a tensor in a VTU; "": by their names, else VTK's
    std::string decimal = "auto";     // of a CSV: point, comma; auto: as the numbers show
};

// The stresses in `bytes`, the whole content of a file; its kind is known by its content.  `name` is for messages.
// All points are finite, all indices in range; there is a case, and every case has a name of its own, of letters,
// digits, '-' and '_'. Throws Error: truncated if the file ends before what it announces, bad_input if it is of no
// known kind, malformed, or without stresses, usage if the options do not fit it.
Samples read(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes);

} // namespace filum::stressfield
