#include "fill/zigzag.hpp"

#include "fill/attempt.hpp"
#include "fill/inset.hpp"
#include "fill/maze.hpp"
#include "fill/rows.hpp"
#include "fill/spiral.hpp"
#include "fill/thin.hpp"
#include "polygon/clip.hpp"

#include <algorithm>

namespace filum::fill {

namespace {

// The parts of `a` that overlap a part of `b`.
Loops touching(const Loops& a, const Loops& b) {
    Loops out;
    const auto others = polygon::split(b).part;
    for (const auto& part : polygon::split(a).part) {
        const auto box = polygon::bounds(part);
        const bool touches = std::any_of(others.begin(), others.end(), [&](const Loops& other) {
            return geom::distance(box, polygon::bounds(other)) == 0 && !polygon::intersect(part, other).empty();
        });
        for (std::size_t i = 0; touches && i < part.size(); ++i) out.add(part[i]);
    }
    return out;
}

// What of the region's own outermost ring lies in parts too thin for a bead.
Loops thin_parts(const Loops& region, double width, double tolerance) {
    const Loops all = first_rings(region, width, tolerance).rings;
    const Loops plain = polygon::simplify(polygon::offset(region, -width / 2, tolerance), tolerance);
    if (all.points == plain.points) return {};
    return polygon::subtract(all, polygon::offset(plain, 2 * tolerance));
}

// The outermost rings of the corridor: its inset by half a bead, and in the region's thin parts what first_rings makes
// of the corridor there.  The acute ends of rows are not followed.
Loops outermost(const Loops& region, const Loops& corridor, double width, double tolerance) {
    const Loops plain = inset(corridor, width / 2), thin = thin_parts(region, width, tolerance);
    if (thin.empty()) return plain;
    const Loops near = polygon::intersect(corridor, polygon::offset(thin, 2 * width));
    const Loops all = first_rings(near, width, tolerance).rings;
    const Loops more = touching(polygon::subtract(all, polygon::offset(near, -width / 2 - tolerance)), thin);
    return polygon::simplify(polygon::unite(plain, more), tolerance);
}

struct ZigzagSetting {
    bool follow;      // the corridors' acute ends too
    double tolerance; // bead widths
    double row;       // wanted height, bead widths
    int lanes;        // that share a wall's odd thickness; 0: no ring is moved
};

constexpr ZigzagSetting kZigzagSettings[] = {{false, 1.0 / 128, 2, 2},   {true, 1.0 / 128, 2, 2},
                                             {true, 1.0 / 1024, 2, 2},   {true, 1.0 / 1024, 2.12, 2},
                                             {true, 1.0 / 1024, 1.9, 2}, {true, 1.0 / 1024, 2, 0}};

Attempt zigzag_by(const Loops& region, double width, const ZigzagSetting& t) {
    const double tolerance = t.tolerance * width;
    const Loops corridor = maze(region, width, t.row * width);
    Attempt out;
    out.outermost =
        t.follow ? first_rings(corridor, width, tolerance).rings : outermost(region, corridor, width, tolerance);
    const Rings rings = nested_rings(out.outermost, width * (1 - kRingOverlap), kShortestRing * width, tolerance);
    out.curves = closed_curves(join_rings(even_spacing(rings, corridor, width, t.lanes, tolerance), width, region));
    out.crossings = count_crossings(out.curves, width);
    return out;
}

} // namespace

std::vector<toolpath::Curve> zigzag(const Loops& region, const ZigzagOptions& o, Notes& notes) {
    const double w = o.bead_width;
    const Loops area = rotated(region, -o.angle);
    Attempt best = best_attempt(std::span<const ZigzagSetting>(kZigzagSettings), true,
                                [&](const ZigzagSetting& s) { return zigzag_by(area, w, s); });
    for (auto& curve : best.curves) rotate(curve.points, o.angle);
    note_unjoined(best.curves, notes);
    // a hair more than half a bead, so that rows side by side become one area
    note_unplaced(region, rotated(inset(best.outermost, -(0.5 + 1.0 / 32) * w), o.angle), w, notes);
    return std::move(best.curves);
}

} // namespace filum::fill
