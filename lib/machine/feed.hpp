// How fast a machine moves along a bead.
#pragma once

#include "machine/profile.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::machine {

// What of an extruding move its feed depends on.
struct Laid {
    toolpath::Role role = toolpath::Role::bead;
    std::uint32_t layer = 0;
    double length = 0, rise = 0; // mm
    double volume = 0;           // mm3
    toolpath::Feature feature = toolpath::Feature::none;
};
Laid laid(const toolpath::Span& span, std::size_t i); // by the segment i -> i + 1

// Its feed, mm/s: that of its role, or, of a bead, of its feature, at most feeds.first_layer on layer 0, lowered so
// that limits.flow and motion.max_speed_z are kept; a lowered feed is a whole number where it is above one.
double bead_feed(const Profile& profile, const Laid& move);

// How long laying each layer takes at its feeds, without travels, s.
struct LayerTimes {
    std::vector<double> seconds;
    void add(const Profile& profile, const toolpath::Span& span);
};

// The share of its feeds that each layer may keep, so that it takes `least` seconds at least.
std::vector<double> pace(const LayerTimes& times, double least);

// The same of a fibre that is to be laid at `feed`: lowered so that motion.max_speed_z is kept, and for nothing else.
double fibre_feed(const Profile& profile, const Laid& move, double feed);

} // namespace filum::machine
