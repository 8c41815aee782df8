#include "fill/contour.hpp"
#include "fill/crossings.hpp"

#include "fill/attempt.hpp"
#include "fill/spiral.hpp"
#include "rings/lanes.hpp"

namespace filum::fill {

std::vector<toolpath::Curve> contour(const polygon::Loops& region, const ContourOptions& o) {
    std::vector<toolpath::Curve> out;
    for (const double share : kShares) {
        out = rings::curves_of(rings::lanes(
            region, {.width = o.bead_width, .most = o.rings, .tolerance = share * tolerance_for(o.bead_width)}));
        if (crossing_pairs(out, o.bead_width).empty()) break;
    }
    return out;
}

} // namespace filum::fill
