#include "fill/zigzag.hpp"

#include "fill/cycle.hpp"
#include "fill/inset.hpp"
#include "fill/maze.hpp"
#include "fill/rows.hpp"
#include "fill/spiral.hpp"
#include "fill/thin.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace filum::fill {

namespace {

// Beads lie a little nearer than their width, so that rounding never opens a seam between them.
constexpr double kOverlap = 1.0 / 512;
constexpr double kShortestRing = 1.3; // bead widths: shorter rings have no room for a link

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

struct Try {
    bool follow;      // the corridors' acute ends too
    double tolerance; // bead widths
    double row;       // wanted height, bead widths
    int lanes;        // that share a wall's odd thickness; 0: no ring is moved
};

constexpr Try kTries[] = {{false, 1.0 / 128, 2, 2},    {true, 1.0 / 128, 2, 2},    {true, 1.0 / 1024, 2, 2},
                          {true, 1.0 / 1024, 2.12, 2}, {true, 1.0 / 1024, 1.9, 2}, {true, 1.0 / 1024, 2, 0}};

struct Attempt {
    std::vector<toolpath::Curve> curves;
    std::size_t crossings = 0;
    Loops first; // the outermost rings
};

Attempt attempt(const Loops& region, double width, const Try& t) {
    const double tolerance = t.tolerance * width;
    const Loops corridor = maze(region, width, t.row * width);
    Attempt out;
    out.first =
        t.follow ? first_rings(corridor, width, tolerance).rings : outermost(region, corridor, width, tolerance);
    const Rings rings = nested_rings(out.first, width * (1 - kOverlap), kShortestRing * width, tolerance);
    for (ClosedLine& line : join_rings(even_spacing(rings, corridor, width, t.lanes, tolerance), width, region))
        out.curves.push_back({true, std::move(line.points), std::move(line.width)});
    out.crossings = count_crossings(out.curves, width);
    return out;
}

} // namespace

std::vector<toolpath::Curve> zigzag(const Loops& region, const ZigzagOptions& o, Notes& notes) {
    const double w = o.bead_width;
    const Loops area = rotated(region, -o.angle);
    std::optional<Attempt> best;
    for (const Try& t : kTries) {
        Attempt now = attempt(area, w, t);
        const auto faults = [](const Attempt& a) { return std::pair{a.crossings, a.curves.size()}; };
        if (!best || (!now.curves.empty() && faults(now) < faults(*best))) best = std::move(now);
        if (best->crossings == 0 && best->curves.size() == 1) break;
    }
    for (auto& curve : best->curves) rotate(curve.points, o.angle);
    if (best->curves.size() > 1) {
        const auto more = best->curves.size() - 1;
        const Vec2 p = best->curves.back().points.front();
        notes.push_back({"", "ring not joined", static_cast<double>(more), "curves", more, -1, p.x, p.y});
    }
    // a hair more than half a bead, so that rows side by side become one area
    note_unplaced(region, rotated(inset(best->first, -(0.5 + 1.0 / 32) * w), o.angle), w, notes);
    return std::move(best->curves);
}

} // namespace filum::fill
