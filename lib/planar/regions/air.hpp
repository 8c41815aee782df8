// Overhangs: the parts of regions that hang in the air.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"

#include <optional>
#include <span>

namespace filum::regions {

// How beads are carried: a bead is carried if half of its width lies on the layer below.
struct CarrierOptions {
    double bead_width = 0; // mm
    double hairline = 0;   // mm; narrower unsupported pieces do not count
};

// The overhang of all layers so far, and its worst place: the point farthest from the layer below.
struct Air {
    double area = 0;         // mm2
    std::size_t layers = 0;  // layers with an overhang
    double reach = 0;        // mm from the worst place to the layer below; infinite if that is empty
    double bridge = 0;       // mm, the shortest straight way over the worst place carried at both ends; 0: none
    std::uint32_t layer = 0; // layer of the worst place
    geom::Vec2 at;
};

// Sets `unsupported` of each upper region: the area farther than half a bead from the layer below, mm2. Only pieces at
// least a hairline wide count. They must also be as large as the dot of a bead, except in regions that lie on nothing.
// `covered` is the area of each region that lies on the layer below, mm2. Adds to `air`; the worst place is found to a
// hairline. Tie: the first.
void hang(std::span<polygon::Region> upper, std::span<const polygon::Region> lower, std::span<const double> covered,
          const CarrierOptions& how, Air& air);

// Adds the overhang of further layers. `further` must have begun with a `reach` that `all` had before, so that it holds
// only worse places.
void add(Air& all, const Air& further);

// A note of the overhang; nothing if there is none.
std::optional<Note> note(const Air& air);
// Whether `code` is that of a note about overhangs.
bool of_air(NoteCode code);

} // namespace filum::regions
