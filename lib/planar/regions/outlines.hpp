// Turns contours into simple outlines: simplified once and split into connected parts.
#pragma once

#include "base/note.hpp"
#include "polygon/clip.hpp"

namespace filum::regions {

// The connected parts of `contours`, in the order of polygon::split(): each with its outer loop first,
// counter-clockwise, then its holes, clockwise. Points are on the grid of 0.1 um; removed points lie within `tolerance`
// mm (+ 0.1 um) of the result. No two edges cross; loops may touch in single points only. Where simplifying made
// outlines meet, they are united (non-zero winding). Gaps narrower than `hairline` mm are closed (gaps.hpp), and a note
// gives the area that this adds; 0 closes none. Parts that still cross themselves are left out, with a note.
// Errors name `layer`; bridges() throws them.
polygon::Parts outlines(const polygon::Loops& contours, double tolerance, double hairline, Notes& notes,
                        int layer = -1);

} // namespace filum::regions
