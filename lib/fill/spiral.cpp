#include "fill/spiral.hpp"

#include "fill/attempt.hpp"
#include "fill/cycle.hpp"
#include "fill/least_radius.hpp"
#include "fill/rounding.hpp"
#include "geom/segment_grid.hpp"
#include "polygon/segments.hpp"
#include "rings/lanes.hpp"

namespace filum::fill {

namespace {

using polygon::Loops;

constexpr double kSmallestHole = 0.02; // bead widths squared: smaller ones close under any bead
constexpr double kRound = 0.4;         // bead widths of path on each side that corners are rounded within
constexpr double kRoundMost = 0.7;     // the same where a least radius asks for more

constexpr double kTinyRing = 0.25; // bead widths squared, laid: a ring that may be left out if it cannot be joined

constexpr double kGrid = 1e-3; // mm

// To the micrometre, which machines are told: what does not cross here does not cross there.
geom::Vec2 snapped(geom::Vec2 p) { return {std::round(p.x * 1e3) / 1e3, std::round(p.y * 1e3) / 1e3}; }

// Whether a bead runs from a to b and back over itself to c: no turn at all, and where it is cut, rounding makes it
// cross itself.
bool spike(geom::Vec2 a, geom::Vec2 b, geom::Vec2 c) {
    constexpr double kFlat = 0.002; // mm
    return dot(b - a, c - b) <= 0 &&
           (geom::point_segment_distance(b, c, a) < kFlat || geom::point_segment_distance(a, b, c) < kFlat);
}

// Puts the line on the grid; drops points that fall together and the tips of spikes.
void tidy(toolpath::Curve& line) {
    for (geom::Vec2& p : line.points) p = snapped(p);
    toolpath::Curve out;
    const auto size = [&] { return out.points.size(); };
    const auto drop = [&] { out.points.pop_back(), out.width.pop_back(); };
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const geom::Vec2 p = line.points[i];
        while (size() > 1 && spike(out.points[size() - 2], out.points.back(), p)) drop();
        if (size() > 0 && out.points.back() == p) continue;
        out.points.push_back(p), out.width.push_back(line.width[i]);
    }
    std::size_t first = 0; // the same where the line closes
    for (bool again = true; again && size() - first > 3;) {
        again = out.points.back() == out.points[first] ||
                spike(out.points[size() - 2], out.points.back(), out.points[first]);
        if (again) {
            drop();
        } else if (spike(out.points.back(), out.points[first], out.points[first + 1])) {
            again = true, ++first;
        }
    }
    if (size() - first < 3) return; // less than a curve: as it was
    line.points.assign(out.points.begin() + static_cast<std::ptrdiff_t>(first), out.points.end());
    line.width.assign(out.width.begin() + static_cast<std::ptrdiff_t>(first), out.width.end());
}

// The rings of the region; with corners of the radius that is asked for, if any.
rings::Rings rings_of(const Loops& region, const SpiralOptions& o, double tolerance, Spiral& out) {
    const double w = o.bead_width, r = o.min_radius;
    const double fine = r > 0 ? std::min(tolerance, w * w / (128 * r)) : tolerance; // vertices turn, too
    rings::Rings all = rings::lanes(region, {.width = w, .tolerance = fine});
    out.unplaced = std::max(0.0, polygon::signed_area(region) - rings::laid_area(all));
    return r > 0 ? with_round_corners(all, w, fine, drawn_radius(r, w / 2, kGrid + fine), out.open) : all;
}

// Leaves open what tiny rings would lay that no link has room for beside: the first curve is the longest.
void leave_tiny_rings(double least, Spiral& spiral) {
    for (std::size_t i = spiral.curves.size(); i-- > 1;) {
        const toolpath::Curve& c = spiral.curves[i];
        double area = 0;
        for (std::size_t k = 0, n = c.points.size(); k < n; ++k)
            area += c.width[k] * geom::distance(c.points[k], c.points[(k + 1) % n]);
        if (area >= least) continue;
        spiral.unplaced += area;
        spiral.curves.erase(spiral.curves.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

Spiral spiral_by(const Loops& region, const SpiralOptions& o, double tolerance, bool wind, bool round) {
    const double w = o.bead_width;
    Spiral out{{}, 0, 0, {"", "left open for the least radius", 0, "mm2", 0}};
    const rings::Rings all = rings_of(region, o, tolerance, out);
    const double reach = std::clamp(0.75 * o.min_radius, kRound * w, kRoundMost * w);
    const auto edges = polygon::segments(region);
    const geom::SegmentGrid grid(edges, 1.5 * w);
    const auto room = [&](geom::Vec2 p) {
        double best = w;
        grid.near({p.x - w, p.y - w}, {p.x + w, p.y + w}, [&](std::uint32_t i) {
            best = std::min(best, geom::point_segment_distance(edges[i].a, edges[i].b, p));
        });
        return best;
    };
    for (ClosedLine& line : join_rings(all, w, region, wind)) {
        if (round && all.size() > 4) line = rounded(with_wide_turns(line, w, room), w, reach, room);
        toolpath::Curve curve{true, std::move(line.points), std::move(line.width)};
        if (o.min_radius <= 0) curve = rings::with_fewer_points(curve, tolerance, rings::kLeastVoid * w * w);
        tidy(curve);
        out.curves.push_back(std::move(curve));
    }
    leave_tiny_rings(kTinyRing * w * w, out);
    return out;
}

Loops without_small_holes(const Loops& region, double least, Notes& notes) {
    Loops out;
    Note closed{"", "hole smaller than a bead closed", 0, "mm2", 0};
    for (std::size_t l = 0; l < region.size(); ++l) {
        const double area = polygon::signed_area(region[l]);
        if (l == 0 || -area >= least) {
            out.add(region[l]);
            continue;
        }
        closed.amount -= area, ++closed.count;
        closed.x = region[l][0].x, closed.y = region[l][0].y;
    }
    if (closed.count > 0) notes.push_back(closed);
    return out;
}

void report(const Spiral& spiral, const SpiralOptions& o, Notes& notes) {
    note_unjoined(spiral.curves, notes);
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
    if (spiral.crossings > 0) {
        const geom::Vec2 at = spiral.curves[0].points[0];
        notes.push_back({"", "curve crosses itself", static_cast<double>(spiral.crossings), "places", spiral.crossings,
                         -1, at.x, at.y});
    }
    if (length > 0) notes.push_back({"", "bead below the least width", length, "mm", 1, -1, where.x, where.y});
}

} // namespace

std::size_t count_crossings(const std::vector<toolpath::Curve>& curves, double cell) {
    std::vector<geom::Segment> all;
    for (const auto& c : curves)
        for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i)
            all.push_back({c.points[i], c.points[i + 1 == c.points.size() ? 0 : i + 1]});
    const geom::SegmentGrid grid(all, cell);
    std::size_t crossings = 0;
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        const geom::Vec2 a = all[i].a, b = all[i].b;
        found.clear(); // a pair may share several cells
        grid.near({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                  [&](std::uint32_t j) {
                      if (j > i && geom::cross_properly(a, b, all[j].a, all[j].b)) found.push_back(j);
                  });
        std::sort(found.begin(), found.end());
        crossings += static_cast<std::size_t>(std::unique(found.begin(), found.end()) - found.begin());
    }
    return crossings;
}

namespace {

// The first of several ways to fill the region, from the best to the safest, whose curves do not cross themselves.
Spiral certified(const Loops& region, const SpiralOptions& o) {
    struct Try {
        double share; // of the tolerance
        bool wind, round;
    };
    const auto [whole, finer] = kShares;
    Spiral out;
    for (const Try t :
         {Try{whole, true, true}, Try{finer, true, true}, Try{finer, true, false}, Try{finer, false, false}}) {
        out = spiral_by(region, o, t.share * tolerance_for(o.bead_width), t.wind, t.round);
        out.crossings = count_crossings(out.curves, o.bead_width);
        if (out.crossings == 0) break;
    }
    return out;
}

} // namespace

Spiral spiral(const polygon::Loops& given, const SpiralOptions& o, Notes& notes) {
    const Loops region = without_small_holes(given, kSmallestHole * o.bead_width * o.bead_width, notes);
    Spiral out = certified(region, o);
    const bool sound = out.curves.size() == 1 && out.crossings == 0;
    if (o.min_radius > 0 && !sound) { // one curve that does not cross itself matters more
        SpiralOptions any = o;
        any.min_radius = 0;
        out = certified(region, any);
    }
    out.unplaced += out.open.amount;
    report(out, o, notes);
    return out;
}

} // namespace filum::fill
