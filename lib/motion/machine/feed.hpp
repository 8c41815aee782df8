// The speed of a machine along a bead.
#pragma once

#include "machine/profile.hpp"
#include "toolpath/path.hpp"

#include <compare>
#include <map>
#include <vector>

namespace filum::machine {

// The data of an extruding move that its feed depends on.
struct ExtrudingMove {
    toolpath::Role role = toolpath::Role::bead;
    std::uint32_t layer = 0;
    double length = 0, rise = 0; // mm
    double volume = 0;           // mm3
    toolpath::Feature feature = toolpath::Feature::none;
    std::uint8_t over_air = 0; // percent of a wall's width
};
ExtrudingMove extruding_move(const toolpath::Span& span, std::size_t i); // of the segment i -> i + 1

// The feed of a move, mm/s.  It is that of the feature if the move fills and the feature has a feed, else that of the
// role; that of a wall partly over air is as Profile::overhang says.  On layer 0 it is at most feeds.first_layer, and
// at most feeds.first_layer_infill there if the move fills an area.  limits.flow and motion.max_speed_z lower it; a
// feed that these two limits lower is a whole number if it is 1 or more.  Last, the layer's pace lowers it, but not
// below limits.least_feed.
double bead_feed(const Profile& profile, const ExtrudingMove& move);

// The lengths of the beads of each layer by their feeds, without travels and fibre.
struct LayerTimes {
    struct Feed {
        double full = 0, least = 0; // mm/s: without a pace, and the least that a pace makes of it
        auto operator<=>(const Feed&) const = default;
    };
    std::vector<std::map<Feed, double>> layers; // mm
    void add(const Profile& profile, const toolpath::Span& span);
};

// The share of its feeds that each layer keeps, so that it takes at least `least` seconds, as far as the least feeds
// allow; 1 for a layer without beads.
std::vector<double> pace(const LayerTimes& times, double least);

// The feed of a move that lays fibre, mm/s: `feed`, lowered only to keep motion.max_speed_z.
double fibre_feed(const Profile& profile, const ExtrudingMove& move, double feed);

} // namespace filum::machine
