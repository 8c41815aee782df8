// Turns contours into connected regions, and finds how these lie on each other.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"
#include "regions/air.hpp"

#include <numbers>
#include <span>
#include <vector>

namespace filum::regions {

struct Options {
    double bead_width = 0.4;  // mm; decides which overlaps a stroke can climb
    double tolerance = 0.001; // mm; largest distance of a removed contour point from the outline
    double hairline = 0;      // mm; narrower gaps, walls and contacts do not count; 0: kHairline of the bead width
};

// A bead of height h has round sides and reaches (1 - pi / 4) h / 2 farther than its width says. So two side by side
// close a gap of twice that. As a share of the width of a bead half as high as wide: 0.107.
inline constexpr double kHairline = (1 - std::numbers::pi / 4) / 2;
inline double hairline(const Options& o) { return o.hairline > 0 ? o.hairline : kHairline * o.bead_width; }

// What a layer lies on: the bed, or the regions of the layer below (none if that layer is missing).
struct Ground {
    bool bed = true;
    std::span<const polygon::Region> regions;
};

// The connected regions of `layer`, in the order of polygon::split(); ids and parents count from 0. Gaps narrower than
// a hairline are closed, and regions nowhere as wide are left out. A note with the number of the layer reports either.
std::vector<polygon::Region> regions(const polygon::Layer& layer, const Options& options, Notes& notes);

// Sets how the regions of a layer lie on those below (none on the bed), and adds their overhang to `air`.
// Precondition: all regions have the same tool; see lay_bodies_on().
void lay_on(std::span<polygon::Region> regions, const Ground& below, const Options& options, Air& air);

} // namespace filum::regions
