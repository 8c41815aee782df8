// Front lines: lines across the fronts of a distance field, with births and deaths that keep their distance.
#pragma once

#include "surfpath/fronts/fronts.hpp"

namespace filum::surfpath::fronts {

enum class FrontLineEnd : std::uint8_t {
    source,   // on a source curve
    rim,      // at a rim, or where lines from elsewhere arrive first
    interior, // a birth or death between neighbours
};

// A line from front to front.
struct FrontLine {
    std::size_t first = 0;   // level of its first spot
    std::vector<Spot> spots; // one per level
    FrontLineEnd begin = FrontLineEnd::source, end = FrontLineEnd::rim;
    // number of its group; lines of a group are born, or die, together
    std::uint32_t born_with = surface::kNone, dies_with = surface::kNone;
    std::uint32_t mate = surface::kNone; // the line that starts at the same place on the other side of the source

    [[nodiscard]] std::size_t last() const { return first + spots.size() - 1; }
};

// When lines are born and die.
struct SpacingRule {
    double spacing = 1;    // mm
    std::size_t group = 1; // number of neighbours that are born, or die, together: 1 or 2
    double shortest = 0;   // mm: shorter lines are left out
};

struct FrontLines {
    std::vector<FrontLine> lines;   // by first level, front, and place on it
    std::size_t born = 0, died = 0; // number of births and deaths between neighbours
    // lower bound on births: per side of a source floor(growth of width / spacing), summed over its rises
    std::size_t bound = 0;
    struct ShortLine {
        std::size_t level;
        Spot spot;     // its last one
        double length; // mm
    };
    std::vector<ShortLine> left_out; // lines that were too short
};

// FrontLines from the sources and wherever there is room for more.
// A gap between two lines exceeds the spacing by e = gap - spacing. If the sum of e over 11 neighbouring gaps
// exceeds 0.55 spacings, a line is born in the middle of the widest of them; if it falls below -0.55, the line
// with the narrowest gaps dies. (For groups of two: 19 gaps, 1.05 spacings.) So widths and counts agree within 6 %
// over any such stretch; halving each gap at 4/3 spacings would leave 8 % of the area void and 8 % overlap.
// Gaps of 1.8 spacings (2.6) are filled at once, and of two lines nearer than 0.35 spacings the younger dies. A
// line that would die less than 3 spacings before a rim continues to it, and one that lives no longer than that is
// left out. Then make_room() evens out the distances. Ties: the first along the front.
FrontLines front_lines(const Fronts& fronts, const SpacingRule& interior);

} // namespace filum::surfpath::fronts
