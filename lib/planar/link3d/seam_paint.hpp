// Begins strokes on faces that are painted for seams, and not on those painted against them.
#pragma once

#include "geom/segment_grid.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace filum::link3d {

struct State;
struct Entry;

// The painted faces where a horizontal plane cuts them.
struct SeamPaint {
    std::vector<geom::Segment> wanted, unwanted;
};

// The paint at a height in mm; empty if nothing is painted.
using SeamPaintAt = std::function<SeamPaint(double)>;

// The entry of the front region where a new stroke begins, by the paint beside its outline.  If faces there are wanted,
// it is the place nearest to their middle.  Otherwise it is `usual`, or, if that lies at an unwanted face, the nearest
// place of the same curve that does not.  Counts starts on wanted faces.
Entry by_paint(State& state, const Entry& usual);

// Counts the front region if faces beside it are wanted, but no stroke begins there.
void count_passed_paint(State& state);

} // namespace filum::link3d
