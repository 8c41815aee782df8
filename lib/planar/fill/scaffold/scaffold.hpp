// Porous scaffolds: straight strands with gaps between them, each layer of a region in one stroke.
#pragma once

#include "base/note.hpp"
#include "fill/scaffold/fronts.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <optional>
#include <vector>

namespace filum::fill::scaffold {

using geom::Vec2;
using polygon::Loops;

struct ScaffoldOptions {
    double bead_width = 0.4; // mm
    double spacing = 1;      // mm between the centre lines of strands, >= bead_width
    // The spacing at a place in the coordinates of the region; none: `spacing` everywhere. With it, `spacing` only
    // limits the radius of turns.
    SpacingAt spacing_at = {};
    double angle = 0;              // rad, of the strands from the x axis
    double shift = 0;              // sideways shift of the strands, in spacings
    int rings = 0;                 // closed rings along the outline and the holes, in the same stroke
    std::optional<Vec2> from = {}; // position of the nozzle
    const Loops* above = nullptr;  // the region above to which the stroke climbs; none: it ends here
};

// Fills one connected region with strands joined to one open curve: a meander. Its turns run half a bead inside the
// outline, or inside the rings. Corners are rounded to half the spacing, at most two beads.
//
// The strands lie on a lattice centred in `frame`. As many as fit are used, across the extent of the frame less the
// beads and rings at its sides. With the outline of a column's first region as `frame`, the strands of all its layers
// line up. A connected part that no line of the lattice meets gets one strand in its middle.
// With `spacing_at`, the strands are fronts (fronts.hpp).
//
// Where holes or notches interrupt strands, the curve follows the boundary to the remaining strands (strand_walk.hpp).
// A stretch of boundary that is passed k times gets k beads of 1 / k of the width, one on the other. So the amount of
// material is right. The note NoteCode::path_runs_twice gives the length.
//
// With `from`, the curve begins at the nearest place of the boundary, so that plain lifts join the layers of a column.
// If that is more than a bead away and `from` lies within the region, the curve begins at `from` and leads there:
// straight, or along the strands if a bead is in between. Without it, the curve begins at an outermost strand.
//
// If the curve ends outside of `above`, it goes back over itself until it is within, half as wide on this stretch both
// times. So a part that shrinks continues as well as one that grows.
//
// Returns one curve, or more if a region thinner than a bead with its rings falls apart, or if a hole cuts strands off.
// Each further curve is a stop. Rings are joined to the curve by join_rings, or the curve continues from its end around
// a ring. A ring that finds no place is a closed curve of its own, with a note. NoteCode::area_unreached gives the
// parts too thin for a bead. Tie: as in strand_walk.hpp. Cost: near-linear in the points and strands.
std::vector<toolpath::Curve> scaffold(const Loops& region, const Loops& frame, const ScaffoldOptions& options,
                                      Notes& notes);

} // namespace filum::fill::scaffold
