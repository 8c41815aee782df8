// Joins closed rows to other rows.
#pragma once

#include "surfpath/plan/plan.hpp"
#include "surfpath/rows/rows.hpp"

namespace filum::surfpath::rows {

struct LoopOptions {
    double spacing = 1;  // mm
    double radius = 2.4; // mm: of shifts from row to row
    double gentle = 2.4; // mm: of shifts in spirals, where there is room
    double cut = 50;     // mm of fibre that a cut costs
    bool tight = false;  // joins by turns of half a spacing come first, as they waste less; otherwise they come last
    double nearest = 1;  // spacings: least distance of lines where they turn
};

struct LoopJoins {
    std::vector<Vec3> crossed; // places where shifts cross
    std::size_t exchanged = 0; // number of joins without a crossing
    double waste = 0;          // mm2 of additional void and overlap of all joins
};

// First closes rows whose ends lie on the same ring of the inset, if no other row ends there or if the ends are near
// each other: they continue along that ring. Such rows shorter than two radii that are alone on their ring are
// dropped.
// Then joins closed rows to the rows beside them: by shifts that keep the radius (splice.hpp), then by exchanges
// (exchange.hpp), then by tighter shifts; if `tight`, exchanges come first. If `tight` and beads may change width
// (`nearest` below 1), those exchanges come first that cost less than a pair of shifts when tight turns count, then
// shifts that keep the radius, then all other exchanges. Long chains of closed rows, and chains
// that are all there is, become spirals instead (winding.hpp).
LoopJoins join_loops(const Surface& s, Rows& rows, const LoopOptions& options);

// Closes strokes whose ends are within two radii of each other and joins them to the strokes beside them. If all
// strokes are such, the longest stays open.
LoopJoins join_strokes(const Surface& s, std::vector<plan::Stroke>& strokes, const LoopOptions& options);

// Adds NoteCode::loop_by_crossing if shifts cross anywhere.
void report_crossings(const std::vector<Vec3>& crossed, double spacing, Notes& notes);

} // namespace filum::surfpath::rows
