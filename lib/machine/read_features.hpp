// Private to lib/machine: reads [features] of a profile.
#pragma once

#include "machine/profile.hpp"
#include "machine/reader.hpp"

namespace filum::machine {

// most_acceleration: mm/s2.  Codes that the profile does not say are those of the controller, if it has them.
void read_features(Document& doc, Controller controller, double most_acceleration, FeatureRules& rules);

} // namespace filum::machine
