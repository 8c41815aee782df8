// Plans several surfaces, which are patches of one part.
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/algorithm.hpp"
#include "surfpath/plan/plan.hpp"

#include <functional>
#include <span>
#include <string>

namespace filum::surfpath {

// The name of patch `k`, or its number from 1 if it has none.
std::string label(std::span<const surface::Sheet> sheets, std::size_t k);

// The algorithm of every surface: `asked` if given, otherwise the one that the stream carries for it. If the stream
// carries none at all, it is geo-fiso for all; if it carries some, surfaces without one get none.
// Throws Error(bad_input) if there is no surface, Error(usage) for an unknown name in the stream.
using Algorithms = std::vector<std::optional<Algorithm>>;
Algorithms algorithms(std::span<const surface::Sheet> sheets, std::optional<Algorithm> asked);

struct Patches {
    std::vector<plan::Plan> plans; // per surface; their notes and facts are moved to the members below
    Notes notes;
    Facts facts;
};

// Plans every surface by `plan(k)`, on `threads` threads. If there are several, facts are named "patch.PATCH.FACT",
// notes end with "on patch PATCH", and errors begin with "patch 'PATCH':". A surface without an algorithm gets an
// empty plan and the note NoteCode::patch_unplanned (area, place). Of several errors that of the first patch is
// thrown.
Patches each_patch(std::span<const surface::Sheet> sheets, const Algorithms& algorithms, int threads,
                   const std::function<plan::Plan(std::size_t)>& plan);

// The toolpaths of all surfaces, one after the other. Strokes are numbered consecutively; travels connect them.
std::vector<toolpath::Span> spans(std::span<const surface::Sheet> sheets, std::span<const plan::Plan> plans,
                                  const plan::SpanOptions& options);

} // namespace filum::surfpath
