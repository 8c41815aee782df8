// Closed rows made part of what is open.
#pragma once

#include "surfpath/plan/plan.hpp"
#include "surfpath/rows/rows.hpp"

namespace filum::surfpath::rows {

struct Loops {
    double spacing = 1;  // mm
    double radius = 2.4; // mm: of the shifts from row to row
    double gentle = 2.4; // mm: likewise, of spirals, where there is room
    double cut = 50;     // mm of fibre: what a cut of it costs as much as
    bool tight = false;  // joins may turn within half a spacing, as that wastes less; else where nothing gentler leads
};

struct Joined {
    std::vector<Vec3> crossed; // where shifts cross
    std::size_t exchanged = 0; // joins without a crossing
    double waste = 0;          // mm2: what all of them leave bare and lay twice
};

// Closes rows that lead nowhere: those of which both ends lie on one ring of the inset, where no other row ends, or
// near to each other, go on along that ring; shorter ones than two radii that are alone there are dropped.  Then closed
// rows become part of the rows beside them: by shifts that keep to the radius (splice.hpp), then by exchanges
// (exchange.hpp), then by tighter shifts; if `tight`, by exchanges first.  But for long chains of them and those that
// are all there is: these become spirals (winding.hpp).
Joined open_loops(const Surface& s, Rows& rows, const Loops& options);

// Strokes whose ends lie within two radii of each other become part of the strokes beside them: closed, and taken in as
// loops are.  If all are such the longest stays open.
Joined join_strokes(const Surface& s, std::vector<plan::Stroke>& strokes, const Loops& options);

// NoteCode::loop_by_crossing, if there are any.
void tell_crossed(const std::vector<Vec3>& crossed, double spacing, Notes& notes);

} // namespace filum::surfpath::rows
