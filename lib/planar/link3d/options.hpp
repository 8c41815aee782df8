// Options for joining regions.
#pragma once

#include "link3d/interlace.hpp"
#include "link3d/seam_paint.hpp"
#include "machine/head.hpp"

#include <cstdint>

namespace filum::link3d {

// How to get to a region that does not lie above the one before it. Where the chosen way is impossible, the stroke
// breaks.
enum class Connect : std::uint8_t {
    stop,    // a break: the nozzle stops, travels and starts again
    inside,  // a straight strand to a region of the same layer
    outside, // an extruded connector around the part, to be trimmed
};

// What a connector outside the part must rest on.
enum class ConnectorSupport : std::uint8_t {
    free,    // anything; it may hang in the air
    carried, // the bed, or a connector one layer below, so that connectors form a fin
};

// Where a stroke begins.
enum class Seam : std::uint8_t {
    nearest, // at the place nearest to the end of the stroke before
    inside,  // near the middle of the last region of the column that it climbs
    back,    // near the place with the greatest y in the last region of the column that it climbs
    place,   // at the place nearest to `seam_at`
};

// How the nozzle gets to the next layer.
enum class Lift : std::uint8_t {
    plain,   // straight up, then sideways
    ramp,    // rises along the beginning of the next curve, whose end overlaps it and adds the missing material
    helical, // rises all the way where each layer has one curve that lies on the one below; else as ramp
};

struct Options {
    double reach = 1.5;           // bead widths; the longest jog
    std::int64_t look_ahead = 16; // regions, >= 1
    Connect connect = Connect::stop;
    ConnectorSupport connector_support = ConnectorSupport::free;
    Seam seam = Seam::nearest;
    geom::Vec2 seam_at{}; // mm, for Seam::place
    SeamPaintAt paint{};  // faces painted for seams, which win over `seam`; empty: none
    Interlace interlace = Interlace::none;
    bool alternate_direction = true; // odd layers run in reverse order of their points
    Lift lift = Lift::plain;
    machine::Head head = {}; // must not touch printed material
};

} // namespace filum::link3d
