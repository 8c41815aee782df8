#include "fill/contour.hpp"

#include "fill/inset.hpp"
#include "fill/spacing.hpp"
#include "fill/spiral.hpp"
#include "fill/thin.hpp"
#include "rings/rings.hpp"

#include <limits>

namespace filum::fill {

namespace {

std::vector<toolpath::Curve> curves_along(const BeadRings& beads) {
    std::vector<toolpath::Curve> out;
    for (std::size_t i = 0; i < beads.loops.size(); ++i)
        out.push_back({true,
                       {beads.loops[i].begin(), beads.loops[i].end()},
                       {beads.width.begin() + beads.loops.start[i], beads.width.begin() + beads.loops.start[i + 1]}});
    return out;
}

// The rings of the first `levels` levels.
Rings outer(const Rings& all, int levels) {
    Rings out;
    for (std::size_t i = 0; i < all.loops.size(); ++i)
        if (all.level[i] < levels) out.loops.add(all.loops[i]), out.level.push_back(all.level[i]);
    return out;
}

} // namespace

std::vector<toolpath::Curve> contour(const Loops& region, const ContourOptions& o, Notes& notes) {
    if (o.fit) {
        const auto all = rings::rings(rings::beading(rings::medial_axis(rings::sites_of(region, 0.005), 0.0025, rings::kWallSlope), o.bead_width, std::min(.1*o.bead_width*o.bead_width, atof(getenv("VS"))*polygon::signed_area(region))), o.rings, 0.005);
        std::vector<toolpath::Curve> out;
        for (std::size_t i = 0; i < all.size(); ++i)
            out.push_back({true, {all.points.begin() + all.start[i], all.points.begin() + all.start[i + 1]},
                           {all.width.begin() + all.start[i], all.width.begin() + all.start[i + 1]}});
        return out;
    }
    struct Try {
        double tolerance; // bead widths
        int lanes;
    };
    const double w = o.bead_width;
    const int levels = o.rings > 0 ? o.rings : std::numeric_limits<int>::max();
    std::vector<toolpath::Curve> out;
    Loops first;
    for (const Try t : {Try{1.0 / 128, 2}, Try{1.0 / 1024, 2}, Try{1.0 / 1024, 0}}) {
        const double tolerance = t.tolerance * w;
        first = o.fit ? first_rings(region, w, tolerance).rings : inset(region, w / 2);
        const Rings rings = outer(nested_rings(first, w * (1 - kRingOverlap), kShortestRing * w, tolerance), levels);
        out = curves_along(even_spacing(rings, region, w, o.fit ? t.lanes : 0, tolerance));
        if (count_crossings(out, w) == 0) break;
    }
    note_unplaced(region, inset(first, -(0.5 + 1.0 / 32) * w), w, notes);
    return out;
}

} // namespace filum::fill
