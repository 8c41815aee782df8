#include "fill/contour.hpp"

#include "fill/inset.hpp"
#include "fill/rings.hpp"
#include "fill/spiral.hpp"
#include "rings/lanes.hpp"

#include <limits>

namespace filum::fill {

namespace {

std::vector<toolpath::Curve> curves_along(const rings::Rings& beads) {
    std::vector<toolpath::Curve> out;
    for (std::size_t i = 0; i < beads.size(); ++i)
        out.push_back({true,
                       {beads.points.begin() + beads.start[i], beads.points.begin() + beads.start[i + 1]},
                       {beads.width.begin() + beads.start[i], beads.width.begin() + beads.start[i + 1]}});
    return out;
}

// The classical rings: those of the first `levels` levels, one bead wide.
std::vector<toolpath::Curve> plain_rings(const Loops& region, double w, int levels) {
    const double tolerance = w / 128;
    const Rings all = nested_rings(inset(region, w / 2), w * (1 - kRingOverlap), kShortestRing * w, tolerance);
    std::vector<toolpath::Curve> out;
    for (std::size_t i = 0; i < all.loops.size(); ++i)
        if (all.level[i] < levels) out.push_back({true, {all.loops[i].begin(), all.loops[i].end()}, {w}});
    return out;
}

} // namespace

std::vector<toolpath::Curve> contour(const Loops& region, const ContourOptions& o, Notes& notes) {
    constexpr double kTolerance = 0.01; // mm
    constexpr double kReach = 0.5 + 1.0 / 32;
    const double w = o.bead_width;
    if (!o.fit) {
        note_unplaced(region, inset(inset(region, w / 2), -kReach * w), w, notes);
        return plain_rings(region, w, o.rings > 0 ? o.rings : std::numeric_limits<int>::max());
    }
    std::vector<toolpath::Curve> out;
    for (const double share : {1.0, 0.125}) {
        const double tolerance = share * std::min(kTolerance, w / 40);
        out = curves_along(rings::lanes(region, {.width = w, .most = o.rings, .tolerance = tolerance}));
        if (count_crossings(out, w) == 0) break;
    }
    return out;
}

} // namespace filum::fill
