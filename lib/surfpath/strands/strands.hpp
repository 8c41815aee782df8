// Lines across the fronts of a distance field, as far apart as they should be: where they are born and where they die.
#pragma once

#include "surfpath/strands/fronts.hpp"

namespace filum::surfpath::strands {

inline constexpr double kParallel = 0.2; // slope against a rim up to which a strand runs along it

enum class StrandEnd : std::uint8_t {
    source, // begins on a source curve
    rim,    // ends at a rim, or where lines from elsewhere come nearer
    law,    // is born, or dies, between its neighbours
};

// A line that goes from front to front.
struct Strand {
    std::size_t first = 0;   // level of its first spot
    std::vector<Spot> spots; // one per level
    StrandEnd begin = StrandEnd::source, end = StrandEnd::rim;
    std::uint32_t born_with = surface::kNone, dies_with = surface::kNone; // same numbers: those of one group
    std::uint32_t mate = surface::kNone; // the strand that begins on the other side of the source at the same place

    [[nodiscard]] std::size_t last() const { return first + spots.size() - 1; }
};

struct Law {
    double spacing = 1;    // mm
    std::size_t group = 1; // so many neighbours are born, or die, together: 1 or 2
    double shortest = 0;   // mm: what is shorter is left out
};

struct Strands {
    std::vector<Strand> strands;    // by their first levels, fronts, and places there
    std::size_t born = 0, died = 0; // by the law
    std::size_t bound = 0; // what must be born at least: per side of a source floor(growth of width / spacing),
                           // summed over stretches where the width grows
    struct Short {
        std::size_t level;
        Spot spot;     // its last one
        double length; // mm
    };
    std::vector<Short> left_out; // what was too short
};

// Strands from the sources on, and wherever there is room for more.
//
// A gap between two strands is e = gap - spacing too wide.  Where the sum of e over 11 neighbouring gaps exceeds 0.55
// spacings, a strand is born in the middle of the widest of them; where it falls below -0.55, that one dies that leaves
// the narrowest gap.  (Groups of two: 19 gaps, 1.05 spacings.)  So widths and counts agree to within 6 % over any such
// stretch, while halving each gap when it is 4/3 spacings wide would leave 8 % of the area bare and lay 8 % twice.
// Gaps of 1.8 spacings (2.6) are filled at once, and of two strands nearer than 0.35 spacings the younger dies.
// What would die less than 3 spacings before a rim goes on to it, and what lives no longer than that is left out.
// Then they make room for each other: see make_room().  Ties: the first along the front.
Strands strands(const Fronts& fronts, const Law& law);

} // namespace filum::surfpath::strands
