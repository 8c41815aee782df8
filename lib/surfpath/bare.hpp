// What a plan leaves without a bead.
#pragma once

#include "surfpath/plan.hpp"

namespace filum::surfpath {

// Adds to the plan the fact "bare": mm2 of the surface that lie farther than `spacing` from every line, so that a whole
// bead is missing there; beyond one per cent of the surface also as a note, with the place that is farthest.  Judged at
// points of the triangles about a third of the spacing apart, by distances in space to lines on triangles that face the
// same way.
void tell_bare(const Surface& surface, Plan& plan, double spacing);

} // namespace filum::surfpath
