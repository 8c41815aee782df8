#include "slice/compensate.hpp"

#include "polygon/clip.hpp"
#include "slice/bores.hpp"

#include <cmath>

namespace filum::slice {

namespace {

using polygon::Loops;

// Widens the holes of one connected part by `by` mm.
Loops with_wider_holes(const Loops& part, double by) {
    Loops outer, holes;
    outer.add(part[0]);
    for (std::size_t i = 1; i < part.size(); ++i) {
        holes.points.insert(holes.points.end(), part[i].rbegin(), part[i].rend());
        holes.close();
    }
    return holes.empty() ? part : polygon::subtract(outer, polygon::offset(holes, by));
}

Loops with_wider_holes_in_all(const Loops& area, double by) {
    Loops all;
    for (const Loops& part : polygon::split(area).part) {
        const Loops own = with_wider_holes(part, by);
        for (std::size_t i = 0; i < own.size(); ++i) all.add(own[i]);
    }
    return polygon::unite(all);
}

void tell(NoteCode code, const Loops& area, std::uint32_t layer, Notes& notes) {
    constexpr double told = 1e-4; // mm2: rounding leaves less at corners
    const double mm2 = polygon::signed_area(area);
    if (!(mm2 > told)) return;
    const geom::Vec2 at = polygon::centroid(area);
    notes.push_back({.code = code, .amount = mm2, .count = 1, .layer = layer, .x = at.x, .y = at.y});
}

// The parts of an area that disappear completely when its outline moves inwards by `width` mm.
Loops lost(const Loops& area, double width) {
    return polygon::subtract(area, polygon::offset(polygon::offset(area, -width), 2 * width));
}

Loops less_foot(const Loops& area, double foot, std::uint32_t layer, Notes& notes) {
    // `thin` is narrower than four times the foot: a circle of that width does not fit into it. It excludes the corners
    // that such a circle misses.
    const Loops wide = polygon::offset(polygon::offset(area, -2 * foot), 2 * foot);
    const Loops thin = polygon::subtract(area, polygon::offset(wide, 2 * foot));
    if (thin.empty()) return polygon::offset(area, -foot);
    tell(NoteCode::foot_kept, thin, layer, notes);
    const Loops kept = polygon::intersect(area, polygon::offset(thin, 3 * foot)); // reaches into the rest
    return polygon::unite(polygon::offset(area, -foot), kept);
}

} // namespace

Loops compensated(const Loops& contours, const Loops& bores, const Compensation& by, std::uint32_t layer,
                  Notes& notes) {
    Loops out = contours;
    if (by.holes != 0) out = with_wider_holes_in_all(out, by.holes);
    if (by.holes != 0) out = with_wider_bores(out, bores, by.holes);
    if (by.xy < 0) tell(NoteCode::compensation_erases, lost(out, -by.xy), layer, notes);
    if (by.xy != 0) out = polygon::offset(out, by.xy);
    if (by.elephant_foot > 0 && layer == 0) out = less_foot(out, by.elephant_foot, layer, notes);
    return out;
}

} // namespace filum::slice
