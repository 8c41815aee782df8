// Numbers and lengths of the joins, by kind.
#pragma once

#include "base/fact.hpp"

#include <cstdint>

namespace filum::link3d {

// Numbers and lengths of all joins between two curves, by kind. strokes = breaks + 1.
struct Counts {
    std::uint64_t strokes = 0;
    std::uint64_t planned = 0;    // strokes that the input asks for: regions without a join
    std::uint64_t lifts = 0;      // joins to a region above
    std::uint64_t ramps = 0;      // lifts on a ramp
    std::uint64_t turns = 0;      // regions printed as one turn of a helix
    std::uint64_t lanes = 0;      // lanes to a place where the next region is in reach
    std::uint64_t shifts = 0;     // lanes to the planned start of the next layer
    std::uint64_t kept = 0;       // starts that interlacing could not move
    std::uint64_t jogs = 0;       // between curves of a region
    std::uint64_t strands = 0;    // straight joins to another region of the layer
    std::uint64_t brims = 0;      // joins from a brim to its region
    std::uint64_t connectors = 0; // joins outside the part
    std::uint64_t breaks = 0;
    std::uint64_t broken = 0;       // breaks in place of a join that was asked for
    std::uint64_t painted = 0;      // strokes that begin on a face painted for seams
    std::uint64_t paint_passed = 0; // regions beside such faces where no stroke begins
    std::uint64_t parted = 0;       // breaks between curves of a region
    double lift_length = 0, lane_length = 0, shift_length = 0, jog_length = 0, strand_length = 0, connector_length = 0,
           travel_length = 0;    // mm
    double connector_free = 0;   // mm of connectors that hang in the air
    double connector_volume = 0; // mm3
};

// The counts by name, for the stream.
Facts facts(const Counts& counts);

} // namespace filum::link3d
