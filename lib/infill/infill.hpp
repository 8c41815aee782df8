// Sparse infill as closed curves (docs/algorithms/infill.md).
//
// The plane is parted into cells of two kinds by lines that never meet, as the surface of a zebra: even cells and odd
// ones.  The outlines of the even cells within an area are closed, cross nothing, pass each line exactly once, and
// follow the area's outline from line to line, which anchors them there.
#pragma once

#include "polygon/region.hpp"

#include <span>

namespace filum::infill {

using polygon::Loops;

// mm: from this spacing on an area stays empty.
inline constexpr double kHollow = 1e6;

struct Lines {
    polygon::Pattern pattern = polygon::Pattern::rows;
    double direction = 0;    // rad, of rows, from the x axis
    double spacing = 2;      // mm, from line to line on average: an area A has lines of length A / spacing
    double bead_width = 0.4; // mm
    double z = 0;            // mm, of the layer: waves depend on it
    double gap = 0;          // mm: no gap is wider, by more lines between those; 0: as the spacing says
    const Loops* rim =
        nullptr; // concentric: what they are drawn in, so that areas of one rim have the same; none: the area
};

// The closed curves that fill `area` (simple): half a bead inside its outline, none nearer than a bead to itself or
// another.  Even cells narrower than a bead get none.  Concentric ones are joined to each other and the outline by
// links of two beads side by side.
Loops loops(const Loops& area, const Lines& lines);

// An area and the lines it gets.
struct Task {
    const Loops* area = nullptr;
    Lines lines;
};

// The same of an area that is parted: each part has lines of its own, and even cells that meet, if only in a corner, go
// on from part to part.
Loops loops(const Loops& area, std::span<const Task> parts);

// mm of all loops.
double length(const Loops& loops);

// The spacing with which, whatever their own says, the loops of all areas lay `density` of them together, mm.  If the
// outlines alone are more than that, the spacing is the widest that is tried: 64 times that of endless lines.
// Concentric lines come and go whole, so in long areas with few of them the share jumps: then the nearest that is
// found.
double spacing_for(std::span<const Task> tasks, double density, double bead_width);

// What the loops of the tasks' areas lay of them with that spacing; of a sample of 48 areas, if there are more.
double share_laid(std::span<const Task> tasks, double spacing, double bead_width);

} // namespace filum::infill
