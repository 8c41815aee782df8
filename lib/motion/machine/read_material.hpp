// Private to lib/motion/machine: reads how a machine feeds its material: [extrusion], [limits] and [travel] of a
// profile.
#pragma once

#include "machine/profile.hpp"
#include "machine/reader.hpp"

namespace filum::machine {

// These throw Error(bad_input) as Document does.
void read_extrusion(Document& doc, Extrusion& e);
void read_limits(Document& doc, Limits& l);
void read_travel(Document& doc, Travel& t);

} // namespace filum::machine
