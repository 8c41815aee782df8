// Surfaces of several components, which have nothing to do with each other but the order that they are laid in.
#pragma once

#include "surfpath/surfpath.hpp"

#include <functional>

namespace filum::surfpath {

using Planner = std::function<Plan(const surface::Sheet&, const Options&)>;

// Every component planned by itself, in parallel, as if there were no other; on triangles of the whole.  From the
// one with the least vertex (by x, y, z) on, always the one is laid next that begins or ends nearest to where the last
// one ended, either way round; cuts between them are told in the note NoteCode::component_cut.  Facts are summed up;
// of those that tell how much at most, the greatest counts.
// A component without a source, of algorithms that need one, or of which the planner says in an error why it cannot be
// laid, is left out, with a note that says so, its area and its place.
// Throws the planner's Error(usage), that of the first component by place; and any of its errors if all are left out.
Plan each_component(const surface::Sheet& sheet, const Options& options, const Planner& plan);

} // namespace filum::surfpath
