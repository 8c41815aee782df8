// Strands: lines across the fronts of a distance field, with births and deaths that keep their distance.
#pragma once

#include "surfpath/strands/fronts.hpp"

namespace filum::surfpath::strands {

inline constexpr double kParallel = 0.2; // largest slope relative to a rim at which a strand runs along it

enum class StrandEnd : std::uint8_t {
    source,   // on a source curve
    rim,      // at a rim, or where lines from elsewhere arrive first
    interior, // a birth or death between neighbours
};

// A line from front to front.
struct Strand {
    std::size_t first = 0;   // level of its first spot
    std::vector<Spot> spots; // one per level
    StrandEnd begin = StrandEnd::source, end = StrandEnd::rim;
    // number of its group; strands of a group are born, or die, together
    std::uint32_t born_with = surface::kNone, dies_with = surface::kNone;
    std::uint32_t mate = surface::kNone; // the strand that starts at the same place on the other side of the source

    [[nodiscard]] std::size_t last() const { return first + spots.size() - 1; }
};

// When strands are born and die.
struct SpacingRule {
    double spacing = 1;    // mm
    std::size_t group = 1; // number of neighbours that are born, or die, together: 1 or 2
    double shortest = 0;   // mm: shorter strands are left out
};

struct Strands {
    std::vector<Strand> strands;    // by first level, front, and place on it
    std::size_t born = 0, died = 0; // number of births and deaths between neighbours
    // lower bound on births: per side of a source floor(growth of width / spacing), summed over its rises
    std::size_t bound = 0;
    struct ShortStrand {
        std::size_t level;
        Spot spot;     // its last one
        double length; // mm
    };
    std::vector<ShortStrand> left_out; // strands that were too short
};

// Strands from the sources and wherever there is room for more.
// A gap between two strands exceeds the spacing by e = gap - spacing. If the sum of e over 11 neighbouring gaps
// exceeds 0.55 spacings, a strand is born in the middle of the widest of them; if it falls below -0.55, the strand
// with the narrowest gaps dies. (For groups of two: 19 gaps, 1.05 spacings.) So widths and counts agree within 6 %
// over any such stretch; halving each gap at 4/3 spacings would leave 8 % of the area void and 8 % overlap.
// Gaps of 1.8 spacings (2.6) are filled at once, and of two strands nearer than 0.35 spacings the younger dies. A
// strand that would die less than 3 spacings before a rim continues to it, and one that lives no longer than that is
// left out. Then make_room() evens out the distances. Ties: the first along the front.
Strands strands(const Fronts& fronts, const SpacingRule& interior);

} // namespace filum::surfpath::strands
