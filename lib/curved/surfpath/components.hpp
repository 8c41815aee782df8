// Plans surfaces of several components: each by itself, then one after the other.
#pragma once

#include "surfpath/surfpath.hpp"

#include <functional>

namespace filum::surfpath {

using Planner = std::function<Plan(const surface::Sheet&, const Options&)>;

// Plans every component by itself, in parallel; places of the result lie on triangles of the whole sheet. The first
// component is the one with the smallest vertex (by x, y, z); next is always the one that begins or ends nearest to
// the end of the one before, reversed if its end is nearer. Cuts between components give the note
// NoteCode::component_cut. Facts are summed; of facts that are maxima the greatest value counts.
// A component is left out, with a note (reason, area in mm2, place), if its algorithm needs a source and it has none,
// or if the planner fails on it.
// Throws the planner's Error(usage), that of the first component by place; and the first error if every component
// fails.
Plan each_component(const surface::Sheet& sheet, const Options& options, const Planner& plan);

} // namespace filum::surfpath
