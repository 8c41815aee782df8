// Joins pieces of contour to closed loops; private to lib/planar/slice.
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "slice/slice.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace filum::slice {

using polygon::Loops;
using polygon::Vec2;

// The edge that a plane crosses: both vertices, the lower number in the high half.
using EdgeKey = std::uint64_t;

// A stretch of contour with open ends.
struct OpenContour {
    std::vector<Vec2> points;
    EdgeKey head = 0, tail = 0; // the edges where it begins and ends
    double turned = 0;          // mm of it that run against their triangles' orientation
    double lid = 0;             // mm of it that run over lids of holes
    double jumped = 0;          // mm of it that run straight between ends of contours
};

double length(const OpenContour& contour);

// Closed contours: those on the surface all along, and those that bridge gaps, holes or openings.
struct ClosedContours {
    Loops whole, guessed;
    double turned = 0; // mm of them that run against their triangles' orientation
};

// Closes `contours` where possible, in these steps:
//    1. Pieces that meet on the same edge are joined, in either direction, as a triangle between them may be flipped.
//    2. Ends at most options.close_gaps apart are joined, nearest first. Pairs of an end and a start come first.
//    3. Ends on the rim of a hole with a lid are joined along `lids`, the lids' contours at this height.
//    4. Wider openings are joined, end to start, up to options.close_openings of the length of the joined contours.
// Two ends are not joined if they are near because their contours run beside each other: those are copies. A closed
// contour takes the direction of most of its length. Notes report what was closed, turned round or left open on
// `layer`. Ties: by position in `contours`.
ClosedContours close_contours(std::vector<OpenContour> contours, const std::function<std::vector<OpenContour>()>& lids,
                              const Options& options, std::int64_t layer, Notes& notes);

} // namespace filum::slice
