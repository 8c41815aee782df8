// The reasons why the strokes of an order end where they do.
#pragma once

#include "machine/heads.hpp"
#include "sequence/order.hpp"
#include "sequence/outline.hpp"

#include <string>
#include <string_view>

namespace filum::sequence {

enum class Cause : std::uint8_t {
    top,      // there is no link upwards
    taken,    // the region ahead continues another stroke
    support,  // the region ahead also rests on a region printed later
    tip,      // the flat of the nozzle would touch a region printed later
    cone,     // the nozzle's cone would
    carriage, // the carriage would
    gantry,   // the gantry would
    open,     // none: the order continues elsewhere
    idle,     // the head of an idle tool on the carriage would touch a region printed later
};
inline constexpr std::size_t kCauses = 9;
std::string_view name(Cause c);

struct End {
    Index stroke = 0;
    Index region = 0; // its last region
    Cause cause = Cause::top;
    Index ahead = kNone;   // the region to which it could have continued: of several the one printed first
    Index awaited = kNone; // the region that had to be printed before `ahead`: of several the one printed last
    double distance = 0;   // mm between the outlines of those two if the head is the cause
};

// One per stroke, in order. `support`: the precedences of `g` that are not due to the head; `outlines` may be empty if
// there are no others.
std::vector<End> ends(const Graph& g, std::span<const Index> order, const Arcs& support,
                      const std::vector<Outline>& outlines, const machine::Heads& heads);

// The number of strokes per cause.
std::vector<Index> tally(const std::vector<End>& ends);

// The ends as a table separated by tabs, with a head line: stroke, region, layer, z, x, y (mm, centre of the region's
// area), cause, ahead, awaited, rise (mm from awaited to ahead), distance (mm); "-" where there is none.
std::string table(const Graph& g, const std::vector<End>& ends);

} // namespace filum::sequence
