#include "hollow/hollow.hpp"

#include "fill/cycle.hpp"
#include "fill/rounding.hpp"
#include "fill/spiral.hpp"
#include "geom/segment_grid.hpp"
#include "infill/infill.hpp"
#include "polygon/clip.hpp"
#include "polygon/segments.hpp"
#include "rings/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace filum::hollow {

namespace {

using fill::BeadRings;
using geom::Vec2;
using polygon::Area;
using polygon::AreaKind;
using polygon::Loops;
using polygon::Region;

constexpr double kTolerance = 0.01; // mm: what a bead's edges may be off
constexpr double kRound = 0.4;      // bead widths of path on each side that corners are rounded within

void add(BeadRings& to, const rings::Rings& from) {
    for (std::size_t r = 0; r < from.size(); ++r) {
        const auto first = to.loops.points.size();
        (void)first;
        to.loops.add({from.points.data() + from.start[r], from.start[r + 1] - from.start[r]});
    }
    to.width.insert(to.width.end(), from.width.begin(), from.width.end());
}

void add(BeadRings& to, const Loops& from, double width) {
    for (std::size_t i = 0; i < from.size(); ++i) to.loops.add(from[i]);
    to.width.resize(to.loops.points.size(), width);
}

// All closed curves of the region, none joined.
BeadRings closed_curves(const Region& r, double w) {
    BeadRings out;
    add(out, rings::lanes(r.loops, {.width = w, .most = static_cast<int>(r.walls), .tolerance = kTolerance}));
    const Loops rest = polygon::offset(r.loops, -(static_cast<double>(r.walls) * w), kTolerance);
    Loops solid = rest;
    for (const Area& a : r.areas) {
        if (a.kind != AreaKind::sparse) continue;
        const Loops here = polygon::intersect(rest, a.loops);
        solid = polygon::subtract(solid, here);
        add(out, infill::loops(here, {a.pattern, a.direction, a.spacing, w}), w);
    }
    for (const Loops& part : polygon::split(solid).part)
        add(out, rings::lanes(part, {.width = w, .tolerance = kTolerance}));
    return out;
}

Vec2 snapped(Vec2 p) { return {std::round(p.x * 1e3) / 1e3, std::round(p.y * 1e3) / 1e3}; }

std::vector<toolpath::Curve> joined(const Region& r, const BeadRings& rings, double w, bool round) {
    const auto edges = polygon::segments(r.loops);
    const geom::SegmentGrid grid(edges, 1.5 * w);
    const auto room = [&](Vec2 p) {
        double best = w;
        grid.near({p.x - w, p.y - w}, {p.x + w, p.y + w}, [&](std::uint32_t i) {
            best = std::min(best, geom::point_segment_distance(edges[i].a, edges[i].b, p));
        });
        return best;
    };
    std::vector<toolpath::Curve> out;
    for (fill::ClosedLine& line : fill::join_rings(rings, w, r.loops, round)) {
        if (round) line = fill::rounded(fill::with_wide_turns(line, w, room), w, kRound * w, room);
        toolpath::Curve curve{true, std::move(line.points), std::move(line.width)};
        curve = rings::with_fewer_points(curve, kTolerance, rings::kLeastVoid * w * w);
        for (Vec2& p : curve.points) p = snapped(p);
        out.push_back(std::move(curve));
    }
    return out;
}

} // namespace

toolpath::RegionPaths fill(const Region& r, const Options& o, Notes& notes) {
    toolpath::RegionPaths out;
    out.region = r.id, out.layer = r.layer, out.z = r.z, out.height = r.height, out.area = r.area;
    out.stroke = r.stroke, out.join = r.join;
    const std::size_t first = notes.size();
    const BeadRings rings = closed_curves(r, o.bead_width);
    for (const bool round : {true, false}) {
        out.curves = joined(r, rings, o.bead_width, round);
        if (fill::count_crossings(out.curves, o.bead_width) == 0) break;
    }
    fill::note_unjoined(out.curves, notes);
    for (std::size_t i = first; i < notes.size(); ++i) notes[i].layer = r.layer;
    return out;
}

} // namespace filum::hollow
