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
using toolpath::Feature;
using geom::Vec2;
using polygon::Area;
using polygon::AreaKind;
using polygon::Loops;
using polygon::Region;

constexpr double kTolerance = 0.01; // mm: what a bead's edges may be off
constexpr double kTinyRing = 0.25;  // bead widths squared, laid: a ring that may be left out if it cannot be joined
constexpr double kRound = 0.4;      // bead widths of path on each side that corners are rounded within

// Closed curves, each of one feature.
struct Loose {
    BeadRings rings;
    std::vector<Feature> feature; // per loop
};

void add(Loose& to, const rings::Rings& from, Feature first, Feature rest) {
    for (std::size_t r = 0; r < from.size(); ++r) {
        to.rings.loops.add({from.points.data() + from.start[r], from.start[r + 1] - from.start[r]});
        to.feature.push_back(from.lane[r] == 1 ? first : rest);
    }
    to.rings.width.insert(to.rings.width.end(), from.width.begin(), from.width.end());
}

void add(Loose& to, const Loops& from, double width, Feature feature) {
    for (std::size_t i = 0; i < from.size(); ++i) to.rings.loops.add(from[i]);
    to.rings.width.resize(to.rings.loops.points.size(), width);
    to.feature.resize(to.rings.loops.size(), feature);
}

// What of `a` is at least 2 `radius` wide.
Loops opened(const Loops& a, double radius) {
    return polygon::offset(polygon::offset(a, -radius, kTolerance), radius, kTolerance);
}

// What walls leave, parted.
struct Division {
    Loops all_sparse;
    std::vector<Loops> sparse; // of each area
    std::vector<const Area*> area;
    std::vector<Loops> solid; // connected parts
};

// What is solid and narrower than a bead becomes sparse, then what is sparse and narrower than two becomes solid: so no
// slivers stand where the outlines of areas run along those of the walls.  Solid parts nowhere as wide as half a bead
// are left open.
Division divided(const Loops& rest, const Region& r, double w) {
    Division out;
    Loops solid = rest;
    for (const Area& a : r.areas)
        if (a.kind == AreaKind::sparse) out.area.push_back(&a), solid = polygon::subtract(solid, a.loops);
    Loops sparse = opened(polygon::subtract(rest, opened(solid, w / 2)), w);
    solid = polygon::subtract(rest, sparse);
    for (const Loops& part : polygon::split(solid).part)
        if (!polygon::offset(part, -w / 4, kTolerance).empty()) out.solid.push_back(part);
    out.all_sparse = sparse;
    for (std::size_t k = 0; k + 1 < out.area.size(); ++k) {
        out.sparse.push_back(polygon::intersect(sparse, out.area[k]->loops));
        sparse = polygon::subtract(sparse, out.sparse.back());
    }
    if (!out.area.empty()) out.sparse.push_back(std::move(sparse));
    return out;
}

// All closed curves of the region, none joined.
Loose closed_curves(const Region& r, double w) {
    Loose out;
    const auto walls =
        rings::first_lanes(r.loops, {.width = w, .most = static_cast<int>(r.walls), .tolerance = kTolerance});
    add(out, walls.lanes, Feature::outer_wall, Feature::wall);
    for (const Loops& rest : walls.rest) {
        const Division parts = divided(rest, r, w);
        std::vector<infill::Task> tasks;
        for (std::size_t k = 0; k < parts.sparse.size(); ++k) {
            const Area& a = *parts.area[k];
            tasks.push_back({&parts.sparse[k], {a.pattern, a.direction, a.spacing, w, r.z}});
        }
        add(out, infill::loops(parts.all_sparse, tasks), w, Feature::infill);
        for (const Loops& part : parts.solid)
            add(out, rings::lanes(part, {.width = w, .tolerance = kTolerance}), Feature::skin, Feature::skin);
    }
    return out;
}

// Every segment of the curves gets the feature of the loop nearest to its middle.
void tell_features(const Loose& from, double w, std::vector<toolpath::Curve>& curves) {
    const auto segments = polygon::segments(from.rings.loops);
    std::vector<std::uint32_t> loop_of;
    for (std::uint32_t l = 0; l < from.rings.loops.size(); ++l) loop_of.resize(from.rings.loops.start[l + 1], l);
    const geom::SegmentGrid grid(segments, 1.5 * w);
    for (auto& c : curves)
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const Vec2 p = geom::lerp(c.points[i], c.points[(i + 1) % c.points.size()], 0.5);
            double best = 2 * w;
            Feature feature = Feature::skin;
            grid.near({p.x - w, p.y - w}, {p.x + w, p.y + w}, [&](std::uint32_t k) {
                const double d = geom::point_segment_distance(segments[k].a, segments[k].b, p);
                if (d < best) best = d, feature = from.feature[loop_of[k]];
            });
            c.feature.push_back(feature);
        }
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

// Leaves open what tiny rings would lay that no link has room for beside: the first curve is the longest.
double leave_tiny(std::vector<toolpath::Curve>& curves, double least) {
    double left = 0;
    for (std::size_t i = curves.size(); i-- > 1;) {
        const toolpath::Curve& c = curves[i];
        double area = 0;
        for (std::size_t k = 0, n = c.points.size(); k < n; ++k)
            area += c.width_at(k) * geom::distance(c.points[k], c.points[(k + 1) % n]);
        if (area >= least) continue;
        left += area;
        curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return left;
}

} // namespace

toolpath::RegionPaths fill(const Region& r, const Options& o, Notes& notes) {
    toolpath::RegionPaths out;
    out.region = r.id, out.layer = r.layer, out.z = r.z, out.height = r.height, out.area = r.area;
    out.stroke = r.stroke, out.join = r.join;
    const std::size_t first = notes.size();
    const Loose loose = closed_curves(r, o.bead_width);
    for (const bool round : {true, false}) {
        out.curves = joined(r, loose.rings, o.bead_width, round);
        if (fill::count_crossings(out.curves, o.bead_width) == 0) break;
    }
    out.unplaced = leave_tiny(out.curves, kTinyRing * o.bead_width * o.bead_width);
    tell_features(loose, o.bead_width, out.curves);
    fill::note_unjoined(out.curves, notes);
    for (std::size_t i = first; i < notes.size(); ++i) notes[i].layer = r.layer;
    return out;
}

} // namespace filum::hollow
