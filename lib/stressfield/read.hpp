// Reading stresses: CSV, CalculiX .frd, VTK .vtu, each also compressed by gzip.
#pragma once

#include "base/note.hpp"
#include "stressfield/samples.hpp"

#include <string_view>

namespace filum::stressfield {

struct ReadOptions {
    std::string columns;     // of a CSV its columns by role, in order; of a VTU the arrays to read; "": by their names
    std::string names;       // of the cases, between commas; "": the file's own
    std::string step;        // of an FRD: a step's number, or "all"
    std::string unit;        // of positions: mm, cm, m, in
    std::string stress_unit; // MPa, Pa, kPa, GPa, psi
};

// The stresses in `bytes`, the whole content of a file; its kind is known by its content.  `name` is for messages.
// All points are finite, all indices in range; there is a case, and every case has a name of its own, of letters,
// digits, '-' and '_'. Throws Error: truncated if the file ends before what it announces, bad_input if it is of no
// known kind, malformed, or without stresses, usage if the options do not fit it.
Samples read(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes);

} // namespace filum::stressfield
