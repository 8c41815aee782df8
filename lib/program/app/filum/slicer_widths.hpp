// Translates the widths of beads, which slicers have for each role.
#pragma once

#include "app/filum/slicer_values.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// Whether a file has widths by role that can hold in this job.
struct WidthRoles {
    bool sparse = false;   // the part has sparse areas, so that inner walls, infill and solid areas can have own widths
    bool supports = false; // there are supports
};

// The options that the key `key` makes: --bead-width, which is the width of outer walls, and --inner-width,
// --infill-width, --solid-width, --support-width and --first-layer-width where they differ from it.  A role without a
// key of its own has the general width; the general key, or nozzle_diameter if there is none, makes its option.
//
// Rules for a width of 0: the role has the general width.  If that is 0, too, PrusaSlicer, OrcaSlicer and their
// relatives take 1.125 nozzle diameters, and for supports and top surfaces the nozzle diameter.  The width of an
// unknown slicer is that of the nozzle.  A percentage refers to the layer height or to the nozzle, as in that slicer,
// and is at least the nozzle diameter.
//
// `remarks` gets a sentence for each percentage, and for each width that differs from the one that is used.
std::vector<std::string> width_words(const SlicerValues& values, const std::string& key, const WidthRoles& roles,
                                     std::vector<std::string>& remarks);

} // namespace filum::app::filum
