// Rounds turns of lines side by side to the least radius.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct TurnRounding {
    double spacing = 1;  // mm
    double radius = 2.4; // mm: least radius
    double nearest = 1;  // spacings: least distance of lines where they turn; less than 1 if beads may be narrower
};

// Rounds the turns of lines that are tighter than the least radius, where it is worth it: where two families of lines
// meet at an angle, each line turns there, and all of them can turn more gently together. A rounded turn is shorter,
// and as much less of the surface is covered. So a turn is rounded if it loses at most as much length as it saves of
// tight length: a share of void counts as much as the same share of tight length. The half turns of pairs fail this
// test. A turn also stays as it is if it would come nearer than `nearest` spacings to another line, or half a spacing
// to a rim, and nearer than before.
void round_turns(const Surface& s, std::vector<Line>& lines, const TurnRounding& o);

} // namespace filum::surfpath::plan
