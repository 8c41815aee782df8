// Strokes, stops, joins, lengths and material of a program, from its moves only.
#pragma once

#include "toolpath/path.hpp"

#include <array>
#include <cstddef>
#include <limits>

namespace filum::metrics::planar {

// A gap is everything between two extruding moves without an extruding one between; moves before the first and after
// the last extruding move are not gaps.
// - stop: a gap that is longer than 0.05 mm (in XY if it is known to have no retraction; otherwise in space, because
//   machines retract on vertical moves, too), or that is known to have a retraction.
// - break: a stop, or a gap that ends more than two layer heights above or below its start: the stroke ends. A stop of
//   at most 0.5 mm in XY that has no known retraction is not a break. Breaks by class, depending on the end of the gap:
//   `hop`: at most 0.5 mm in XY; otherwise `travel` within a layer, or `climb` to another.
struct PathStatistics {
    std::size_t extruding_moves = 0;
    std::size_t stops = 0, breaks = 0;
    std::size_t hops = 0, travels = 0, climbs = 0;
    std::array<std::size_t, toolpath::kRoles>
        joins{}; // by role: uninterrupted lengths without a gap or another role between; [bead] stays 0
    std::array<double, toolpath::kRoles> length{}; // mm by role, in space
    std::array<double, toolpath::kRoles> volume{}; // mm3 by role
    std::size_t bare_climbs = 0; // beads that continue on another layer without a gap and without a join
    std::size_t jumps = 0;       // spans that do not begin at the end of the one before: counted as travels
    double longest_gap = 0;      // mm in XY
    geom::Vec3 lo{kFar, kFar, kFar}, hi{-kFar, -kFar, -kFar}; // of the extruding moves

    [[nodiscard]] std::size_t strokes() const { return extruding_moves > 0 ? breaks + 1 : 0; }

    // The end of the last move, and the gap since the last extruding one.
    static constexpr double kFar = std::numeric_limits<double>::infinity();
    geom::Vec3 at{}, gap_start{};
    double gap_xy = 0, gap_way = 0;          // mm
    bool gap_taken = false, gap_held = true; // retraction in it is known; no retraction in it is known
    bool begun = false, in_gap = false;
    toolpath::Role last = toolpath::Role::bead;
};

// Adds the moves of `span`. Extruding segments without motion are left out.
void follow(PathStatistics& to, const toolpath::Span& span);

} // namespace filum::metrics::planar
