// Corners of a closed bead rounded, and points that say nothing left out.  Private to lib/rings.
#pragma once

#include "rings/lines.hpp"

namespace filum::rings {

// The line with each point moved to the mean of what lies within 0.4 of its bead's width along the line, wherever it
// turns with less than that for a radius: parallel corners stay parallel, and no point moves farther than 0.2 widths,
// so that neighbours cannot meet.  What the bead loses in length there it gains in width, as far as it stays inside.
BeadLine rounded(const BeadLine& line);

// The line on a grid of 1 um, which machines are told, with the fewest points (taken greedily from the first) such that
// it is off by at most `tolerance` mm in position and at the edges of the bead, and by an eighth of the bead's width.
// Longer segments whose width changes are divided, because a machine lays each with one width.
BeadLine thinned(const BeadLine& line, double tolerance);

} // namespace filum::rings
