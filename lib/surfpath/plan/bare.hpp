// What a plan leaves bare, and what it lays twice.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct Cover {
    double surface = 0; // mm2
    double laid = 0;    // mm2: length times width
    double covered = 0; // mm2 within half a width of a line
    double missing = 0; // mm2 farther than a width from every line: there a whole bead is missing
    Vec3 widest;        // of what is not covered: the place farthest from any line
    Vec3 thickest;      // where most is laid twice

    [[nodiscard]] double bare() const { return surface - covered; }
    [[nodiscard]] double overlap() const { return std::max(0.0, laid - covered); } // as `metrics` has it
};

// Judged at points of the triangles about a third of the width apart, by distances in space to lines on triangles that
// face the same way.  Places are those of such points; of equals, the first.
// `part`: how many triangles count, the first ones.
Cover cover(const Surface& surface, const Plan& plan, double width, std::uint32_t part = surface::kNone);

// Adds that to the plan: facts "bare" (what is missing), "uncovered" and "laid-twice", mm2, and notes with a place of
// NoteCode::no_line_near beyond 1 % of the surface, NoteCode::area_bare and NoteCode::area_doubled beyond 4 %.
void tell_cover(const Surface& surface, Plan& plan, double width, std::uint32_t part = surface::kNone);

} // namespace filum::surfpath::plan
