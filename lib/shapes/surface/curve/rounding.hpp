// Rounds the tight turns of lines on a surface, all lines together.
#pragma once

#include "surface/curve/line.hpp"

#include <limits>

namespace filum::surface::curve {

struct RoundingOptions {
    double spacing = 1;  // mm between lines
    double limit = 0;    // mm: turns tighter than this are rounded
    double radius = 0;   // mm: the radius that they get; at least `limit`
    double corridor = 0; // mm: greatest movement of a point
    double nearest = 0;  // mm: least distance between lines that movements may cause, twice that to a rim; 0: any
    // mm: the area between the old and the new place of a stretch may be this times the tight length that it saves
    double worth = std::numeric_limits<double>::infinity();
};

struct RoundingResult {
    std::vector<Line> lines;
    std::vector<char> moved; // per line: whether any part of it is not as it was
};

// Rounds turns of the lines that are tighter than the limit, all lines together. Points move to the inside of a turn
// and, before and after it, to the outside, by the same area. A stretch that moves must save tight length, make no new
// kinks (turns.hpp), and be worth its area; otherwise it stays where it was. With a finite worth, turns by too great an
// angle for the corridor stay from the start. Ends of open lines stay. Stretches that do not move are exactly as they
// were; moved ones have points where they cross edges.
RoundingResult rounded(const Surface& s, std::span<const Line> lines, const RoundingOptions& options);

} // namespace filum::surface::curve
