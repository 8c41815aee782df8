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
#include <limits>

namespace filum::hollow {

namespace {

using geom::Vec2;
using polygon::Area;
using polygon::AreaKind;
using polygon::Loops;
using polygon::Region;
using toolpath::Feature;

constexpr double kTolerance = 0.01;      // mm: what a bead's edges may be off
constexpr double kFine = kTolerance / 8; // where the curve would cross itself
constexpr double kNeck = 1.0 / 16;
constexpr std::size_t kCrossing = 1000; // curves: as bad as a crossing
constexpr double kTinyRing = 0.25;      // bead widths squared, laid: a ring that may be left out if it cannot be joined
constexpr double kRound = 0.4;          // bead widths of path on each side that corners are rounded within

// A way to join, from the best to the safest.
struct Try {
    double tolerance; // mm
    bool wind, round;
    double open = 0; // bead widths: necks of solid parts narrower than twice that are cut
};
constexpr Try kTries[] = {{kTolerance, true, true},
                          {kFine, true, true},
                          {kFine, true, true, kNeck},
                          {kFine, true, false, kNeck},
                          {kFine, false, false, kNeck}};

// Closed lines whose points carry a bead width.
struct BeadRings {
    Loops loops;
    std::vector<double> width; // mm, per point
};

// Closed curves, each of one feature.
struct Loose {
    BeadRings rings;
    std::vector<Feature> feature; // per loop
};

// The first `walls` lanes are walls.
void add(Loose& to, const rings::Rings& from, std::uint32_t walls) {
    for (std::size_t r = 0; r < from.size(); ++r) {
        to.rings.loops.add({from.points.data() + from.start[r], from.start[r + 1] - from.start[r]});
        const auto lane = static_cast<std::uint32_t>(from.lane[r]);
        to.feature.push_back(lane > walls ? Feature::solid : lane == 1 ? Feature::outer_wall : Feature::wall);
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

bool has_sparse(const Region& r) {
    return std::any_of(r.areas.begin(), r.areas.end(), [](const Area& a) { return a.kind == AreaKind::sparse; });
}

// The connected parts of what is at least 2 `radius` wide of `parts`.
std::vector<Loops> in_parts(const std::vector<Loops>& parts, double radius) {
    std::vector<Loops> out;
    for (const Loops& part : parts)
        for (Loops& piece : polygon::split(opened(part, radius)).part) out.push_back(std::move(piece));
    return out;
}

// All closed curves of the region, none joined.
Loose closed_curves(const Region& r, double w, const Try& how) {
    Loose out;
    if (!has_sparse(r)) {
        add(out, rings::lanes(r.loops, {.width = w, .tolerance = how.tolerance}), r.walls);
        return out;
    }
    const auto walls =
        rings::first_lanes(r.loops, {.width = w, .most = static_cast<int>(r.walls), .tolerance = how.tolerance});
    add(out, walls.lanes, r.walls);
    for (const Loops& rest : walls.rest) {
        const Division parts = divided(rest, r, w);
        std::vector<infill::Task> tasks;
        for (std::size_t k = 0; k < parts.sparse.size(); ++k) {
            const Area& a = *parts.area[k];
            tasks.push_back({&parts.sparse[k], {a.pattern, a.direction, a.spacing, w, r.z, a.gap}});
        }
        add(out, infill::loops(parts.all_sparse, tasks), w, Feature::infill);
        for (const Loops& part : how.open > 0 ? in_parts(parts.solid, how.open * w) : parts.solid)
            add(out, rings::lanes(part, {.width = w, .tolerance = how.tolerance}), 0);
    }
    return out;
}

bool is_top(const Region& r, Vec2 p) {
    return std::any_of(r.areas.begin(), r.areas.end(),
                       [&](const Area& a) { return a.kind == AreaKind::skin_top && polygon::contains(a.loops, p); });
}

// Of a region that is no part.
Feature feature_beside(const Region& r, Vec2 p) {
    if (r.is == polygon::RegionClass::rim) return Feature::skirt;
    return is_top(r, p) ? Feature::interface : Feature::support;
}

// Every segment of the curves gets the feature of the loop nearest to its middle.
void tell_features(const Region& r, const Loose& from, double w, std::vector<toolpath::Curve>& curves) {
    const auto segments = polygon::segments(from.rings.loops);
    std::vector<std::uint32_t> loop_of;
    for (std::uint32_t l = 0; l < from.rings.loops.size(); ++l) loop_of.resize(from.rings.loops.start[l + 1], l);
    const geom::SegmentGrid grid(segments, 1.5 * w);
    for (auto& c : curves)
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const Vec2 p = geom::lerp(c.points[i], c.points[(i + 1) % c.points.size()], 0.5);
            if (r.is != polygon::RegionClass::part) {
                c.feature.push_back(feature_beside(r, p));
                continue;
            }
            double best = 2 * w;
            Feature feature = Feature::solid;
            grid.near({p.x - w, p.y - w}, {p.x + w, p.y + w}, [&](std::uint32_t k) {
                const double d = geom::point_segment_distance(segments[k].a, segments[k].b, p);
                if (d < best) best = d, feature = from.feature[loop_of[k]];
            });
            c.feature.push_back(feature == Feature::solid && is_top(r, p) ? Feature::top : feature);
        }
}

Vec2 snapped(Vec2 p) { return {std::round(p.x * 1e3) / 1e3, std::round(p.y * 1e3) / 1e3}; }

std::vector<toolpath::Curve> joined(const Region& r, const BeadRings& beads, double w, const Try& how) {
    const auto edges = polygon::segments(r.loops);
    const geom::SegmentGrid grid(edges, 1.5 * w);
    const auto room = [&](Vec2 p) {
        double best = w;
        grid.near({p.x - w, p.y - w}, {p.x + w, p.y + w}, [&](std::uint32_t i) {
            best = std::min(best, geom::point_segment_distance(edges[i].a, edges[i].b, p));
        });
        return best;
    };
    const rings::Rings rings{beads.loops.points, beads.width, beads.loops.start,
                             std::vector<int>(beads.loops.size(), 1)};
    std::vector<toolpath::Curve> out;
    for (fill::ClosedLine& line : fill::join_rings(rings, w, r.loops, how.wind)) {
        if (how.round) line = fill::rounded(fill::with_wide_turns(line, w, room), w, kRound * w, room);
        toolpath::Curve curve{true, std::move(line.points), std::move(line.width)};
        curve = rings::with_fewer_points(curve, how.tolerance, rings::kLeastVoid * w * w);
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
    Loose loose;
    std::size_t fewest = std::numeric_limits<std::size_t>::max(); // crossings count more than curves
    for (const Try& t : kTries) {
        Loose parts = closed_curves(r, o.bead_width, t);
        auto curves = joined(r, parts.rings, o.bead_width, t);
        const double left = leave_tiny(curves, kTinyRing * o.bead_width * o.bead_width);
        const std::size_t faults = curves.size() + kCrossing * fill::count_crossings(curves, o.bead_width);
        if (faults >= fewest) continue;
        fewest = faults, loose = std::move(parts), out.curves = std::move(curves), out.unplaced = left;
        if (fewest == 1) break;
    }
    tell_features(r, loose, o.bead_width, out.curves);
    fill::note_unjoined(out.curves, notes);
    for (std::size_t i = first; i < notes.size(); ++i) notes[i].layer = r.layer;
    return out;
}

} // namespace filum::hollow
