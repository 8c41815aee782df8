// Pieces of contour to closed loops; private to lib/slice.
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

// Where a plane crosses one edge: both vertices of the edge, the lower number in the high half.
using EdgeKey = std::uint64_t;

// A stretch of contour with open ends.
struct OpenContour {
    std::vector<Vec2> points;
    EdgeKey head = 0, tail = 0; // the edges on which it begins and ends
    double turned = 0;          // mm of it that run against their triangles' orientation
    double lid = 0;             // mm of it that run over the lids of holes
    double jumped = 0;          // mm of it that run straight from one end of a contour to another
};

double length(const OpenContour& contour);

// Closed contours: of surface all along, and those that are led over gaps, holes and openings in part.
struct Closed {
    Loops whole, guessed;
    double turned = 0; // mm of them that run against their triangles' orientation
};

// Closes what can be closed of `contours`, in this order: pieces that meet on the same edge, whichever way they run (a
// triangle between them is flipped); ends no farther apart than options.close_gaps, nearest first, one's end to the
// other's start before anything else; ends on the rim of a hole that has a lid, along `lids`, the lids' own contours at
// this height; wider openings, end to start, up to options.close_openings of the length of what is joined.
// Two ends that are near because the contours run beside each other are not joined: copies, not continuations.
// Contours run as most of their length does.  Notes what was closed, turned round and left open on `layer`.
// Ties: by position in `contours`.
Closed close_contours(std::vector<OpenContour> contours, const std::function<std::vector<OpenContour>()>& lids,
                      const Options& options, std::int64_t layer, Notes& notes);

} // namespace filum::slice
