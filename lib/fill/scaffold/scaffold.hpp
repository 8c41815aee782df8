// Porous scaffolds: straight strands with gaps between them, each layer of a region in one stroke.
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <optional>
#include <vector>

namespace filum::fill::scaffold {

using geom::Vec2;
using polygon::Loops;

struct ScaffoldOptions {
    double bead_width = 0.4;       // mm
    double spacing = 1;            // mm between the centre lines of strands, >= bead_width
    double angle = 0;              // rad, of the strands from the x axis
    double shift = 0;              // spacings by which the strands are moved across themselves
    int rings = 0;                 // closed rings along the outline and the holes, of the same stroke
    std::optional<Vec2> from = {}; // where the nozzle is
};

// Strands across one connected region, joined to one open curve: a meander whose turns run half a bead inside the
// outline (inside the rings), their corners rounded to half the spacing, at most two beads.
//
// The strands lie on a lattice that is centred in `frame` (of its extent across the strands, less what beads and rings
// take, as many as fit): the outline of a column's first region keeps the strands of all its layers in line.  A
// connected part of the region that no line of the lattice meets gets one strand in its middle.
//
// Where holes or notches interrupt strands, the curve walks along the boundary to those that are left
// (strand_walk.hpp). A stretch of boundary that is passed k times is laid in k beads of a k-th of the width, one on the
// other, so that the material stays right; the note NoteCode::path_runs_twice tells the length.  With `from` the curve
// begins at the place of the boundary next to it, so that the layers of a column are joined by plain lifts; else at an
// outermost strand.
//
// One curve; more where a region thinner than a bead (and its rings) falls apart, or strands on the edge of a hole are
// cut off: each further one is a stop.  Rings are joined to the curve as rings to each other (join_rings), or it
// leads on from its end round one; a ring that finds no place is a closed curve by itself, with a note.  Parts too thin
// for a bead are noted as NoteCode::area_unreached. Tie: as strand_walk.hpp.  Cost: near-linear in the points and
// strands.
std::vector<toolpath::Curve> scaffold(const Loops& region, const Loops& frame, const ScaffoldOptions& options,
                                      Notes& notes);

} // namespace filum::fill::scaffold
