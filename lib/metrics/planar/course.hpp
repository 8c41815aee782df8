// The course of a program: strokes, stops, joins, lengths, material, told from the moves alone.
#pragma once

#include "toolpath/path.hpp"

#include <array>
#include <cstddef>
#include <limits>

namespace filum::metrics::planar {

// A gap is what lies between two extruding moves with no extruding one between; what comes before the first and after
// the last extruding move is no gap.
//   stop    a gap whose way is longer than 0.05 mm (in XY, where material is known not to be taken back; else in space,
//           as machines take back on a way straight up, too), or in which material is known to be taken back
//   break   a stop, or a gap that ends more than two layer heights above or below its start: the stroke ends.  A stop
//           at most 0.5 mm aside in which nothing is known to be taken back is none.
// Breaks by class, by where the gap leads: `hop` at most 0.5 mm aside, else `travel` within a layer or `climb` to
// another.
struct Course {
    std::size_t extruding_moves = 0;
    std::size_t stops = 0, breaks = 0;
    std::size_t hops = 0, travels = 0, climbs = 0;
    std::array<std::size_t, toolpath::kRoles>
        joins{}; // by role: stretches without a gap or another role between; [bead] stays 0
    std::array<double, toolpath::kRoles> length{}; // mm by role, in space
    std::array<double, toolpath::kRoles> volume{}; // mm3 by role
    std::size_t bare_climbs = 0;                   // beads that go on on another layer with neither gap nor join
    std::size_t jumps = 0;  // spans that do not begin where the one before ended: counted as travels
    double longest_gap = 0; // mm in XY
    geom::Vec3 lo{kFar, kFar, kFar}, hi{-kFar, -kFar, -kFar}; // of the extruding moves

    [[nodiscard]] std::size_t strokes() const { return extruding_moves > 0 ? breaks + 1 : 0; }

    // Where the last move ended, and the gap since the last extruding one.
    static constexpr double kFar = std::numeric_limits<double>::infinity();
    geom::Vec3 at{}, gap_start{};
    double gap_xy = 0, gap_way = 0;          // mm
    bool gap_taken = false, gap_held = true; // material is taken back in it; is known not to be
    bool begun = false, in_gap = false;
    toolpath::Role last = toolpath::Role::bead;
};

// Adds the moves of `span`.  An extruding segment that does not move at all is left out.
void follow(Course& course, const toolpath::Span& span);

} // namespace filum::metrics::planar
