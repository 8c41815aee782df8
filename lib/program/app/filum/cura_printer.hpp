// Describes a printer of Cura by the settings of PrusaSlicer, whose macros Filum's machines understand.
#pragma once

#include "app/filum/slicer_file.hpp"

namespace filum::app::filum {

// The settings of PrusaSlicer for the printer that settings of Cura describe: its bed, firmware, temperatures, and the
// G-code of its start and end.  Values in braces of the G-code become macros: {name} and {name, extruder}; a name that
// is unknown stays as it is in a comment, as in Cura.  Where the start names no temperature, codes that heat come
// before it, as Cura writes them.  No settings if the file describes no printer.
// Throws Error(bad_input) for a firmware that Filum does not write for.
SlicerFile cura_printer(const SlicerFile& file);

} // namespace filum::app::filum
