#include "fill/rows/zigzag.hpp"

#include "fill/join/attempt.hpp"
#include "fill/join/crossings.hpp"
#include "fill/join/cycle.hpp"
#include "fill/rings/lanes.hpp"
#include "fill/rows/maze.hpp"
#include "polygon/clip.hpp"
#include "polygon/stretches.hpp"

#include <optional>
#include <utility>

namespace filum::fill::rows {

namespace {

using polygon::Loops;

// Settings of one attempt, from the best to the last resort.
struct AttemptSettings {
    double share; // of join::tolerance_for()
    double row;   // wanted height of a corridor of two rows, bead widths
};
constexpr AttemptSettings kAttempts[] = {
    {join::kShares[0], 2}, {join::kShares[1], 2}, {join::kShares[1], 2.12}, {join::kShares[1], 1.9}};

struct ZigzagFill {
    std::vector<toolpath::Curve> curves;
    std::size_t crossings = 0; // of the curves' segments
    double unplaced = 0;       // mm2 that no bead reaches
};

// Fills a region in the frame where its rows are level.
ZigzagFill lay_rows(const Loops& region, const ZigzagOptions& o, const AttemptSettings& how) {
    const double w = o.bead_width, tolerance = how.share * join::tolerance_for(w);
    rings::FirstLanes outer{{}, {region}};
    if (o.rings > 0) outer = rings::first_lanes(region, {.width = w, .most = o.rings, .tolerance = tolerance});
    rings::Rings core;
    for (const Loops& part : outer.rest)
        core.add(rings::lanes(maze(part, w, how.row * w), {.width = w, .tolerance = tolerance}));
    const double laid = rings::laid_area(outer.lanes) + rings::laid_area(core);
    ZigzagFill out{{}, 0, std::max(0.0, polygon::signed_area(region) - laid)};
    if (!o.linked) out.curves = rings::curves_of(std::exchange(outer.lanes, {}));
    outer.lanes.add(core);
    for (auto& curve : join::join_rings(outer.lanes, w, region)) out.curves.push_back(std::move(curve));
    out.crossings = join::crossing_pairs(out.curves, w).size();
    return out;
}

} // namespace

std::vector<toolpath::Curve> zigzag(const Loops& region, const ZigzagOptions& o, Notes& notes, double* unplaced) {
    const Loops level = polygon::rotated(region, -o.angle);
    const auto faults = [](const ZigzagFill& a) { return std::pair{a.crossings, a.curves.size()}; };
    std::optional<ZigzagFill> best;
    for (const AttemptSettings& how : kAttempts) {
        ZigzagFill now = lay_rows(level, o, how);
        if (!best || (!now.curves.empty() && faults(now) < faults(*best))) best = std::move(now);
        if (best->crossings == 0 && (best->curves.size() == 1 || !o.linked)) break;
    }
    for (auto& curve : best->curves) polygon::rotate(curve.points, o.angle);
    if (best->crossings > 0) join::uncross(best->curves, o.bead_width, notes);
    if (o.linked) join::note_unjoined(best->curves, notes);
    if (unplaced != nullptr) *unplaced = best->unplaced;
    return std::move(best->curves);
}

} // namespace filum::fill::rows
