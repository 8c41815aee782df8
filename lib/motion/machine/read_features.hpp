// Private to lib/motion/machine: reads [features] of a profile.
#pragma once

#include "machine/profile.hpp"
#include "machine/reader.hpp"

namespace filum::machine {

// Reads [features] into `rules`.  `most_acceleration`, mm/s2, is the largest value allowed.  Codes that the profile
// leaves out are those of the controller, if it has them.  Throws Error(bad_input) as Document does.
void read_features(Document& doc, Controller controller, double most_acceleration, FeatureRules& rules);

} // namespace filum::machine
