// How regions are to be joined.
#pragma once

#include "link3d/interlace.hpp"
#include "machine/head.hpp"

#include <cstdint>

namespace filum::link3d {

// What becomes of a join to a region that does not lie above the one before it.  What cannot be joined is a break.
enum class Connect : std::uint8_t {
    stop,    // a break: the nozzle stops, travels and starts again
    inside,  // a strand straight over to a region of the same layer
    outside, // an extruded connector around the part, to be trimmed
};

// What a connector outside lies on.
enum class Strand : std::uint8_t {
    free,    // whatever is below, or nothing
    carried, // the bed, or the connector one layer below: they grow to a fin
};

// Where a stroke begins.
enum class Seam : std::uint8_t {
    nearest, // at the place nearest to where the stroke before ended
    inside,  // near the middle of the column that it is going to climb
    back,    // at its farthest end in y
    place,   // at the place nearest to `seam_at`
};

// How the nozzle gets to the next layer.
enum class Lift : std::uint8_t {
    plain,   // straight up, then on
    ramp,    // rising along the beginning of the next curve, whose end overlaps it with what is missing there
    helical, // rising all the way, where a column has one curve per layer that lies on the one below; else ramps
};

struct Options {
    double reach = 1.5;           // bead widths: the longest jog
    std::int64_t look_ahead = 16; // regions, >= 1
    Connect connect = Connect::stop;
    Strand strand = Strand::free;
    Seam seam = Seam::nearest;
    geom::Vec2 seam_at{}; // mm, of Seam::place
    Interlace interlace = Interlace::none;
    std::int64_t seed = 1;           // of random starts, >= 0
    bool alternate_direction = true; // each layer runs the other way round
    Lift lift = Lift::plain;
    machine::Head head = {}; // what must pass over what is printed
};

} // namespace filum::link3d
