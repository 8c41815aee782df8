#include "fill/spiral.hpp"

#include "fill/doubled.hpp"
#include "fill/finish.hpp"
#include "fill/join/attempt.hpp"
#include "fill/join/crossings.hpp"
#include "fill/join/cycle.hpp"
#include "fill/least_radius.hpp"
#include "fill/rings/lanes.hpp"
#include "fill/volume.hpp"
#include "toolpath/grid.hpp"
#include "toolpath/merge.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

namespace filum::fill {

namespace {

using polygon::Loops;

// The rings of the region, with corners of min_radius if that is set.
rings::Rings rings_of(const Loops& region, const SpiralOptions& o, double tolerance, Spiral& out) {
    const double w = o.bead_width, r = o.min_radius;
    const double fine = r > 0 ? std::min(tolerance, w * w / (128 * r)) : tolerance; // the line also turns at vertices
    rings::Rings all = rings::lanes(region, {.width = w, .tolerance = fine});
    out.unplaced = std::max(0.0, polygon::signed_area(region) - rings::laid_area(all));
    return r > 0 ? with_round_corners(all, w, fine, drawn_radius(r, w / 2, toolpath::kLeastMove + fine), out.open)
                 : all;
}

Spiral spiral_by(const Loops& region, const SpiralOptions& o, const join::Attempt& how) {
    const double w = o.bead_width, tolerance = how.share * join::tolerance_for(w);
    Spiral out{{}, 0, 0, {NoteCode::area_left_for_radius, 0, 0}};
    const rings::Rings all = rings_of(region, o, tolerance, out);
    const Rounded corners = how.round ? Rounded::everywhere : Rounded::nowhere;
    // a right angle's parabola that leaves r^2 / 3 turns no tighter than r
    const double r = std::min(o.min_radius, w), open = r * r / 3;
    out.curves = finished(all, region, {w, tolerance, how.wind, corners, open, r <= 0});
    leave_tiny(out.curves, w);
    double lost = rings::laid_area(all); // mm2 lost by joining and with tiny rings
    for (const auto& curve : out.curves) lost -= rings::laid_area(curve);
    out.unplaced += std::max(0.0, lost);
    return out;
}

// The region without holes smaller than `least` mm2, which a note reports.
Loops without_small_holes(const Loops& region, double least, Notes& notes) {
    Loops out;
    Note closed{NoteCode::hole_closed_small, 0, 0};
    for (std::size_t l = 0; l < region.size(); ++l) {
        const double area = polygon::signed_area(region[l]);
        if (l == 0 || -area >= least) {
            out.add(region[l]);
            continue;
        }
        closed.amount -= area;
        ++closed.count;
        closed.x = region[l][0].x;
        closed.y = region[l][0].y;
    }
    if (closed.count > 0) notes.push_back(closed);
    return out;
}

void report(const Spiral& spiral, const SpiralOptions& o, Notes& notes) {
    join::note_unjoined(spiral.curves, notes);
    double length = 0;
    geom::Vec2 where;
    for (const auto& c : spiral.curves)
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const std::size_t j = i + 1 == c.points.size() ? 0 : i + 1;
            if ((c.width[i] + c.width[j]) / 2 >= o.min_width) continue;
            length += geom::distance(c.points[i], c.points[j]);
            where = c.points[i];
        }
    if (spiral.open.count > 0) notes.push_back(spiral.open);
    if (o.min_radius > 0) {
        const Note tight = tight_turns(spiral.curves, o.bead_width / 2, o.min_radius);
        if (tight.count > 0) notes.push_back(tight);
    }
    const double dot = std::numbers::pi / 4 * o.bead_width * o.bead_width; // mm2; less is a crumb
    const Doubled doubled = doubled_at_turns(spiral.curves);
    if (doubled.area > dot) {
        double laid = 0; // mm2
        for (const auto& c : spiral.curves) laid += rings::laid_area(c);
        if (doubled.area > kMostChange * laid)
            notes.push_back({NoteCode::area_doubled, doubled.area, 1, -1, doubled.at.x, doubled.at.y});
    }
    if (length > 0) notes.push_back({NoteCode::bead_too_thin, length, 1, -1, where.x, where.y});
}

// Tries several ways to fill the region, from the best to the safest. Returns the first that gives one curve which does
// not cross itself, if need be after some points have moved; else the one with the fewest crossings, then the fewest
// curves.
Spiral certified(const Loops& region, const SpiralOptions& o) {
    const auto faults = [](const Spiral& s) { return std::pair{s.crossings, s.curves.size()}; };
    std::optional<Spiral> best;
    for (const join::Attempt& how : join::kAttempts) {
        Spiral now = spiral_by(region, o, how);
        now.crossings = toolpath::part_crossings(now.curves, o.bead_width).size();
        if (!best || faults(now) < faults(*best)) best = std::move(now);
        if (best->crossings == 0 && best->curves.size() <= 1) break;
    }
    return std::move(*best);
}

} // namespace

Spiral spiral(const polygon::Loops& given, const SpiralOptions& o, Notes& notes) {
    const Loops region = without_small_holes(given, rings::kLeastVoid * o.bead_width * o.bead_width, notes);
    Spiral out = certified(region, o);
    const bool sound = out.curves.size() == 1 && out.crossings == 0;
    if (o.min_radius > 0 && !sound) { // one curve that does not cross itself matters more than the radius
        SpiralOptions any = o;
        any.min_radius = 0;
        out = certified(region, any);
    }
    if (out.crossings > 0) out.crossings = join::uncross(out.curves, o.bead_width, notes);
    out.unplaced += out.open.amount;
    report(out, o, notes);
    return out;
}

std::vector<toolpath::Curve> contour(const polygon::Loops& region, const ContourOptions& o) {
    std::vector<toolpath::Curve> out;
    for (const double share : join::kShares) {
        out = rings::curves_of(rings::lanes(
            region, {.width = o.bead_width, .most = o.rings, .tolerance = share * join::tolerance_for(o.bead_width)}));
        if (join::crossing_pairs(out, o.bead_width).empty()) break;
    }
    return out;
}

} // namespace filum::fill
