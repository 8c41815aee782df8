// What joins there are.
#pragma once

#include "base/fact.hpp"

#include <cstdint>

namespace filum::link3d {

// Every join of two curves, by class; strokes = breaks + 1.
struct Counts {
    std::uint64_t strokes = 0;
    std::uint64_t planned = 0;    // strokes, by the joins that the input asks for
    std::uint64_t lifts = 0;      // to a region above
    std::uint64_t ramps = 0;      // of those, by a ramp
    std::uint64_t turns = 0;      // regions that are a turn of a helix
    std::uint64_t lanes = 0;      // of those, with a lane through the region below
    std::uint64_t shifts = 0;     // lanes to where the next layer is to begin
    std::uint64_t kept = 0;       // starts that were to move and could not
    std::uint64_t jogs = 0;       // between curves of a region
    std::uint64_t strands = 0;    // to another region of the layer, straight
    std::uint64_t brims = 0;      // from the brim to its region
    std::uint64_t connectors = 0; // outside the part
    std::uint64_t breaks = 0;
    std::uint64_t broken = 0; // of those, where the input asked for a join
    std::uint64_t parted = 0; // and between curves of a region
    double lift_length = 0, lane_length = 0, shift_length = 0, jog_length = 0, strand_length = 0, connector_length = 0,
           travel_length = 0;    // mm
    double connector_free = 0;   // mm of connectors that nothing carries
    double connector_volume = 0; // mm3
};

// The counts by name, for the stream.
Facts facts(const Counts& counts);

} // namespace filum::link3d
