// What hangs in the air.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"

#include <optional>
#include <span>

namespace filum::regions {

// How beads are carried: one lies on the layer below if half of its width does.
struct Carried {
    double bead_width = 0; // mm
    double hairline = 0;   // mm; an unsupported piece nowhere as wide is none
};

// What of all layers so far hangs in the air, and the worst place: the point farthest from what is below it.
struct Air {
    double area = 0;         // mm2
    std::size_t layers = 0;  // with any
    double reach = 0;        // mm from that point to the layer below; infinite if that is empty
    double bridge = 0;       // mm of the shortest straight way over it that is carried at both ends; 0: there is none
    std::uint32_t layer = 0; // where it is
    geom::Vec2 at;
};

// Sets `unsupported` of each upper region: the area farther than half a bead from the layer below, in pieces at least a
// hairline wide and, but for regions that lie on nothing, as large as the dot of a bead.  `covered` is how much of each
// region lies on the layer below, mm2.  Adds to `air`; the worst place is found to a hairline, the first of several.
void hang(std::span<polygon::Region> upper, std::span<const polygon::Region> lower, std::span<const double> covered,
          const Carried& how, Air& air);

// Adds what hangs of further layers, each looked at with `reach` at what it was before, or later.
void add(Air& all, const Air& further);

// What to say of it in one line; nothing if nothing hangs.
std::optional<Note> note(const Air& air);
// Whether a note of that code is about what hangs.
bool of_air(NoteCode code);

} // namespace filum::regions
