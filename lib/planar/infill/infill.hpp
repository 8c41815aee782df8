// Sparse infill as closed curves (docs/algorithms/infill.md).
//
// Lines that never meet divide the plane into even and odd cells, like the stripes of a zebra. The loops are the
// outlines of the even cells within an area. They are closed, never cross, follow each line exactly once, and follow
// the area's outline from one line to the next, which anchors them there.
#pragma once

#include "polygon/region.hpp"

#include <span>

namespace filum::infill {

using polygon::Loops;

// mm: an area with at least this spacing stays empty.
inline constexpr double kHollow = 1e6;

// Share: below it, the lines of an area can be counted, and one more or less matters.
inline constexpr double kFew = 0.08;

struct Lines {
    polygon::InfillPattern pattern = polygon::InfillPattern::rows;
    double direction = 0;       // rad from the x axis, of rows
    double spacing = 2;         // mm between lines on average: an area A has lines of length A / spacing
    double bead_width = 0.4;    // mm
    double z = 0;               // mm, height of the layer, on which waves depend
    double gap = 0;             // mm: further lines keep every gap within this; 0: no further lines
    const Loops* rim = nullptr; // concentric lines follow this outline, so that areas with one rim share lines;
                                // nullptr: the area itself
};

// The closed curves that fill `area` (simple). They stay half a bead inside its outline, and at least a bead from
// themselves and each other. Even cells narrower than a bead are left out. Concentric curves are joined to each other
// and to the outline by links of two beads side by side.
Loops loops(const Loops& area, const Lines& lines);

// An area and the lines in it.
struct Task {
    const Loops* area = nullptr;
    Lines lines;
};

// The closed curves that fill `area`, which is divided into `parts` with lines of their own. Where areas of parts
// overlap the first one counts, and the last one where no other part is. Even cells that meet, if only in a corner,
// continue from part to part. Without parts there are no curves.
Loops loops(const Loops& area, std::span<const Task> parts);

// The total length of the loops in mm.
double length(const Loops& loops);

// The spacing in mm at which the loops of all tasks together fill the share `density` of the areas; the tasks' own
// spacings are ignored. If the outlines alone fill more than that, the result is the widest spacing tried, 64 times
// that of endless lines.
//
// Concentric lines come and go as whole lines, so in long areas with few of them the share jumps. Then the result is
// the spacing with the nearest share found.
double spacing_for(std::span<const Task> tasks, double density, double bead_width);

// The share of the areas that the loops fill at `spacing` mm. Many areas are measured by a sample: about every n-th, so
// that it has 48 areas, or at least 9 with 100 m of lines together.
double share_laid(std::span<const Task> tasks, double spacing, double bead_width);

} // namespace filum::infill
