// Voids and overlap of a plan.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct Coverage {
    double surface = 0;   // mm2
    double deposited = 0; // mm2: length times width
    double covered = 0;   // mm2 within half a width of a line
    double missing = 0;   // mm2 farther than a width from every line, where a whole bead is missing
    Vec3 widest;          // the uncovered sample point farthest from any line
    Vec3 thickest;        // a point of the cube with the greatest overlap

    [[nodiscard]] double voids() const { return surface - covered; }
    [[nodiscard]] double overlap() const { return std::max(0.0, deposited - covered); } // as in `metrics`
};

// Measures the coverage of the first `part` triangles at points about a third of a width apart. Distances are
// Euclidean, to segments on triangles that face the same way. Ties: the first point.
Coverage cover(const Surface& surface, const Plan& plan, double width, std::uint32_t part = surface::kNone);

// Measures the coverage and adds it to the plan: facts "bare" (missing), "uncovered" and "laid-twice" in mm2; the note
// NoteCode::no_line_near if more than 1 % of the surface is missing, NoteCode::area_bare and NoteCode::area_doubled
// for voids and overlap of more than 4 %.
void report_coverage(const Surface& surface, Plan& plan, double width, std::uint32_t part = surface::kNone);

} // namespace filum::surfpath::plan
