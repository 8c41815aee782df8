// How fast a machine moves along a bead.
#pragma once

#include "machine/profile.hpp"
#include "toolpath/path.hpp"

namespace filum::machine {

// Feed of the extruding segment i -> i + 1 of `span`, mm/s: that of its role, at most feeds.first_layer on layer 0,
// lowered so that limits.flow and motion.max_speed_z are kept; a lowered feed is a whole number where it is above one.
double bead_feed(const Profile& profile, const toolpath::Span& span, std::size_t i);

// The same of a fibre that is to be laid at `feed`: lowered so that motion.max_speed_z is kept, and for nothing else.
double fibre_feed(const Profile& profile, const toolpath::Span& span, std::size_t i, double feed);

} // namespace filum::machine
