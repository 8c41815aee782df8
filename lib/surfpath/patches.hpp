// Several surfaces, patches of one part, each with its plan.
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/algorithm.hpp"
#include "surfpath/plan/plan.hpp"

#include <functional>
#include <span>
#include <string>

namespace filum::surfpath {

// What to call patch `k`: its name, else its number, from 1.
std::string spoken(std::span<const surface::Sheet> sheets, std::size_t k);

// Per surface the algorithm to lay it by: the one `asked` for, or else the one that the surface carries.  If none
// carries one, that is geo-fiso for all; else those without have none.
// Throws Error(bad_input) if there is no surface, Error(usage) if one carries a name that is no algorithm's.
using Algorithms = std::vector<std::optional<Algorithm>>;
Algorithms algorithms(std::span<const surface::Sheet> sheets, std::optional<Algorithm> asked);

struct Patches {
    std::vector<plan::Plan> plans; // per surface; notes and facts moved out
    Notes notes;
    Facts facts;
};

// Every surface planned by `plan(k)`, on `threads` threads.  Of several surfaces, facts are named "patch.PATCH.FACT",
// notes end with "on patch PATCH", and errors begin with "patch 'PATCH':".  A surface without an algorithm has an empty
// plan and a note, NoteCode::patch_unplanned, with its area and place.  The first error, by patches, is thrown.
Patches each_patch(std::span<const surface::Sheet> sheets, const Algorithms& algorithms, int threads,
                   const std::function<plan::Plan(std::size_t)>& plan);

// The toolpaths of all, one after the other, strokes numbered on; travels lead from each to the next.
std::vector<toolpath::Span> spans(std::span<const surface::Sheet> sheets, std::span<const plan::Plan> plans,
                                  const plan::Laying& laying);

} // namespace filum::surfpath
