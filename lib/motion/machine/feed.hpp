// The speed of a machine along a bead.
#pragma once

#include "machine/profile.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::machine {

// The data of an extruding move that its feed depends on.
struct Laid {
    toolpath::Role role = toolpath::Role::bead;
    std::uint32_t layer = 0;
    double length = 0, rise = 0; // mm
    double volume = 0;           // mm3
    toolpath::Feature feature = toolpath::Feature::none;
};
Laid laid(const toolpath::Span& span, std::size_t i); // of the segment i -> i + 1

// The feed of a move, mm/s.  It is that of the feature if the move fills and the feature has a feed, else that of the
// role.  It is at most feeds.first_layer on layer 0.  The layer's pace lowers it, then limits.flow and
// motion.max_speed_z; a feed that these two limits lower is a whole number if it is 1 or more.
double bead_feed(const Profile& profile, const Laid& move);

// The time that the beads of each layer take at their feeds, without travels and fibre, s.
struct LayerTimes {
    std::vector<double> seconds;
    void add(const Profile& profile, const toolpath::Span& span);
};

// The share of its feeds that each layer keeps, so that it takes at least `least` seconds; 1 for a layer without beads.
std::vector<double> pace(const LayerTimes& times, double least);

// The feed of a move that lays fibre, mm/s: `feed`, lowered only to keep motion.max_speed_z.
double fibre_feed(const Profile& profile, const Laid& move, double feed);

} // namespace filum::machine
