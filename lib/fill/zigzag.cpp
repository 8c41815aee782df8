#include "fill/zigzag.hpp"

#include "fill/attempt.hpp"
#include "fill/crossings.hpp"
#include "fill/cycle.hpp"
#include "fill/maze.hpp"
#include "fill/rows.hpp"
#include "fill/spiral.hpp"
#include "fill/uncross.hpp"
#include "rings/lanes.hpp"

namespace filum::fill {

std::vector<toolpath::Curve> zigzag(const Loops& region, const ZigzagOptions& o, Notes& notes, double* unplaced) {
    const double w = o.bead_width, whole = polygon::signed_area(region);
    const Loops area = rotated(region, -o.angle);
    Attempt best = best_rows(true, [&](const RowSetting& s) {
        const Loops corridor = maze(area, w, s.row * w);
        const auto lanes = rings::lanes(corridor, {.width = w, .tolerance = s.share * tolerance_for(w)});
        Attempt out{closed_curves(join_rings(lanes, w, area)), 0, std::max(0.0, whole - rings::laid_area(lanes))};
        out.crossings = crossing_pairs(out.curves, w).size();
        return out;
    });
    for (auto& curve : best.curves) rotate(curve.points, o.angle);
    if (best.crossings > 0) uncross(best.curves, w, notes);
    note_unjoined(best.curves, notes);
    if (unplaced != nullptr) *unplaced = best.unplaced;
    return std::move(best.curves);
}

} // namespace filum::fill
