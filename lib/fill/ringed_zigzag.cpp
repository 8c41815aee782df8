#include "fill/ringed_zigzag.hpp"

#include "fill/attempt.hpp"
#include "fill/crossings.hpp"
#include "fill/cycle.hpp"
#include "fill/maze.hpp"
#include "fill/rows.hpp"
#include "fill/spiral.hpp"
#include "fill/uncross.hpp"
#include "polygon/clip.hpp"
#include "rings/lanes.hpp"

namespace filum::fill {

namespace {

// The lanes of the corridors that `part` is walled into.
rings::Rings corridor_lanes(const Loops& part, const RingedZigzagOptions& o, const RowSetting& s) {
    rings::Rings out;
    const Loops corridors = maze(rotated(part, -o.angle), o.bead_width, s.row * o.bead_width);
    for (const Loops& corridor : polygon::split(rotated(corridors, o.angle)).part)
        out.add(rings::lanes(corridor, {.width = o.bead_width, .tolerance = s.share * tolerance_for(o.bead_width)}));
    return out;
}

Attempt ringed_zigzag_by(const Loops& region, const RingedZigzagOptions& o, const RowSetting& s) {
    const double w = o.bead_width;
    rings::FirstLanes outer =
        rings::first_lanes(region, {.width = w, .most = o.rings, .tolerance = s.share * tolerance_for(w)});
    rings::Rings core;
    for (const Loops& part : outer.rest) core.add(corridor_lanes(part, o, s));
    const double laid = rings::laid_area(outer.lanes) + rings::laid_area(core);
    Attempt out{{}, 0, std::max(0.0, polygon::signed_area(region) - laid)};
    if (o.linked) {
        outer.lanes.add(core);
        out.curves = closed_curves(join_rings(outer.lanes, w, region));
    } else {
        out.curves = rings::curves_of(outer.lanes);
        for (auto& curve : closed_curves(join_rings(core, w, region))) out.curves.push_back(std::move(curve));
    }
    out.crossings = crossing_pairs(out.curves, w).size();
    return out;
}

} // namespace

std::vector<toolpath::Curve> ringed_zigzag(const Loops& region, const RingedZigzagOptions& o, Notes& notes,
                                           double* unplaced) {
    Attempt best = best_rows(o.linked, [&](const RowSetting& s) { return ringed_zigzag_by(region, o, s); });
    if (best.crossings > 0) uncross(best.curves, o.bead_width, notes);
    if (o.linked) note_unjoined(best.curves, notes);
    if (unplaced != nullptr) *unplaced = best.unplaced;
    return std::move(best.curves);
}

} // namespace filum::fill
