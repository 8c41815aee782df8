#include "link3d/counts.hpp"

namespace filum::link3d {

Facts facts(const Counts& c) {
    const auto n = [](std::uint64_t count) { return static_cast<double>(count); };
    return {{"", "strokes", n(c.strokes), "strokes"},
            {"", "lifts", n(c.lifts), ""},
            {"", "ramps", n(c.ramps), ""},
            {"", "turns", n(c.turns), ""},
            {"", "lanes", n(c.lanes), ""},
            {"", "shifts", n(c.shifts), ""},
            {"", "kept-starts", n(c.kept), ""},
            {"", "jogs", n(c.jogs), ""},
            {"", "strands", n(c.strands), ""},
            {"", "brims", n(c.brims), ""},
            {"", "connectors", n(c.connectors), ""},
            {"", "breaks", n(c.breaks), ""},
            {"", "broken-joins", n(c.broken), ""},
            {"", "painted-starts", n(c.painted), ""},
            {"", "stops-in-regions", n(c.parted), ""},
            {"", "lift-length", c.lift_length, "mm"},
            {"", "lane-length", c.lane_length, "mm"},
            {"", "shift-length", c.shift_length, "mm"},
            {"", "jog-length", c.jog_length, "mm"},
            {"", "strand-length", c.strand_length, "mm"},
            {"", "connector-length", c.connector_length, "mm"},
            {"", "connector-free", c.connector_free, "mm"},
            {"", "connector-volume", c.connector_volume, "mm3"},
            {"", "travel-length", c.travel_length, "mm"}};
}

} // namespace filum::link3d
