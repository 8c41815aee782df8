#include "fill/hollow/hollow.hpp"

#include "base/density.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "fill/finish.hpp"
#include "fill/hollow/features.hpp"
#include "fill/hollow/over_air.hpp"
#include "fill/hollow/pieces.hpp"
#include "fill/join/attempt.hpp"
#include "fill/join/crossings.hpp"
#include "fill/join/cycle.hpp"
#include "fill/rings/lanes.hpp"
#include "fill/spiral.hpp"
#include "infill/infill.hpp"
#include "polygon/clip.hpp"
#include "polygon/inside_test.hpp"
#include "polygon/stretches.hpp"
#include "polygon/strips.hpp"
#include "toolpath/grid.hpp"
#include "toolpath/identify.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::fill::hollow {

namespace {

using geom::Vec2;
using polygon::Area;
using polygon::AreaKind;
using polygon::Loops;
using polygon::Region;
using toolpath::Feature;

constexpr double kTolerance = 0.01; // mm: tolerance of bead edges
constexpr double kOfSkins = 0.75;   // of the tolerance: no other bead covers the seams of a skin
constexpr double kStripGive = 0.25; // of a strip's height: rows are 0.75 to 1.25 beads wide

// Adds rings. The first `walls` lanes become walls, lane 1 with the feature `first`; other lanes are solid.
void add(LooseCurves& to, const rings::Rings& from, std::uint32_t walls, Feature first = Feature::outer_wall) {
    to.rings.add(from);
    for (const int lane : from.lane) {
        const bool wall = static_cast<std::uint32_t>(lane) <= walls;
        to.feature.push_back(!wall ? Feature::solid : lane == 1 ? first : Feature::wall);
    }
}

void add(LooseCurves& to, const Loops& from, double width, Feature feature) {
    to.rings.add({from.points, std::vector(from.points.size(), width), from.start, std::vector<int>(from.size(), 1)});
    to.feature.resize(to.rings.size(), feature);
}

// The area inside the walls, divided.
struct Division {
    Loops sparse;
    std::vector<Loops> solid;      // connected parts
    std::vector<Loops> bridge;     // connected parts
    std::vector<double> direction; // rad, of each bridge
};

// Moves bridges from `solid` to `out`, together with places beside them that are narrower than a bead. `depth` is the
// total width of the walls in mm.
//
// A bridge takes nothing farther than two beads from its reach, so it is cut from a window of the solid area. The
// outermost bead of the window may differ from the whole area, and has no influence.
void take_bridges(const Region& r, double depth, double w, Loops& solid, Division& out) {
    constexpr double kWindow = 4; // bead widths around the reach
    Loops all;
    std::vector<geom::Box2> boxes; // of the bridges taken so far
    for (const Area& a : r.areas) {
        if (a.kind != AreaKind::bridge) continue;
        // rows end over the walls of the layer below
        const Loops reach = polygon::offset(a.loops, depth, kTolerance);
        if (reach.empty()) continue;
        const Vec2 margin{kWindow * w, kWindow * w};
        const geom::Box2 near = polygon::bounds(reach), window{near.lo - margin, near.hi + margin};
        Loops local = polygon::within_box(solid, window), taken;
        for (std::size_t k = 0; k < boxes.size(); ++k)
            if (geom::meet(boxes[k], window)) taken.add(out.bridge[k]);
        if (!taken.empty()) local = polygon::subtract(local, taken);
        const Loops over = polygon::opened(polygon::intersect(local, reach), w, kTolerance);
        if (over.empty()) continue;
        const Loops beside = polygon::opened_difference(local, over, w / 2, kTolerance);
        for (Loops& part : polygon::split(polygon::opened_difference(local, beside, w, kTolerance)).part) {
            if (polygon::intersect(part, a.loops).empty()) continue;
            all.add(part);
            boxes.push_back(polygon::bounds(part));
            out.bridge.push_back(std::move(part));
            out.direction.push_back(a.direction);
        }
    }
    if (!all.empty()) solid = polygon::opened_difference(solid, all, w / 4, kTolerance);
}

// Adds a ring in each strip, two beads high, along the bridge: rows that turn where the bridge is carried.
void add_rows(LooseCurves& to, const Loops& bridge, double direction, double w, double tolerance) {
    const Loops level = polygon::rotated(bridge, -direction);
    const auto cuts = polygon::strip_bounds(level, 2 * w, kStripGive);
    const auto box = polygon::bounds(level);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        Loops frame;
        frame.add(std::vector<Vec2>{{box.lo.x - w, cuts[k]},
                                    {box.hi.x + w, cuts[k]},
                                    {box.hi.x + w, cuts[k + 1]},
                                    {box.lo.x - w, cuts[k + 1]}});
        const Loops strip = polygon::rotated(polygon::intersect(level, frame), direction);
        for (const Loops& part : polygon::split(strip).part) {
            if (polygon::offset(part, -w / 4, kTolerance).empty()) continue;
            const auto rows = rings::lanes(part, {.width = w, .tolerance = tolerance});
            to.rings.add(rows);
            to.feature.resize(to.rings.size(), Feature::bridge);
        }
    }
}

// Divides `rest`. Solid parts narrower than a bead become sparse, then sparse parts narrower than two beads become
// solid. So no slivers remain where the outlines of areas run along those of the walls. Solid parts nowhere as wide as
// half a bead are left open.
//
// Outlines of areas run along those of the walls, and of each other. So areas are compared after both were moved apart
// by half the width that counts: `core` are the places where a bead fits into the solid part.
Division divided(const Loops& rest, const Region& r, double depth, double w) {
    Division out;
    Loops areas;
    for (const Area& a : r.areas)
        if (a.kind == AreaKind::sparse) areas.add(a.loops);
    Loops solid;
    if (!areas.empty()) {
        const Loops core =
            polygon::subtract(polygon::offset(rest, -w / 2, kTolerance), polygon::offset(areas, w / 2, kTolerance));
        out.sparse = polygon::offset(rest, -w, kTolerance);
        if (!core.empty()) out.sparse = polygon::subtract(out.sparse, polygon::offset(core, 3 * w / 2, kTolerance));
        out.sparse = polygon::offset(out.sparse, w, kTolerance);
    }
    if (!out.sparse.empty())
        solid = polygon::opened_difference(rest, out.sparse, w / 4, kTolerance);
    else if (!polygon::offset(rest, -w / 4, kTolerance).empty())
        solid = rest;
    if (!solid.empty()) take_bridges(r, depth, w, solid, out);
    out.solid = polygon::split(solid).part;
    return out;
}

bool has(const Region& r, AreaKind kind) {
    return std::any_of(r.areas.begin(), r.areas.end(), [&](const Area& a) { return a.kind == kind; });
}

// The width of the lines in `sparse`, a sparse part of the region, mm. All areas that meet it have the same, since a
// setting with other widths has a zone of its own. `usual`: the width of areas that name none.
double line_width(const Region& r, const Loops& sparse, double usual) {
    for (const Area& a : r.areas)
        if (a.kind == AreaKind::sparse && a.width > 0 && !polygon::intersect(sparse, a.loops).empty()) return a.width;
    return usual;
}

// Adds the curves inside walls that are `depth` mm wide in total, with beads w mm wide, and `solid` mm in solid parts.
void add_inside(LooseCurves& to, const Loops& rest, const Region& r, double depth, double w, double solid,
                double tolerance) {
    const Division parts = divided(polygon::simplify(rest, kTolerance), r, depth, w);
    const double lines = line_width(r, parts.sparse, w);
    std::vector<infill::Task> tasks;
    bool concentric = false;
    for (const Area& a : r.areas) {
        if (a.kind != AreaKind::sparse) continue;
        tasks.push_back({&a.loops, {a.pattern, a.direction, a.spacing, lines, r.z, a.gap}});
        concentric = concentric || a.pattern == polygon::InfillPattern::concentric;
    }
    Loops rim;
    if (concentric) rim = polygon::offset(polygon::simplify(r.loops, kTolerance), -depth, kTolerance);
    for (infill::Task& t : tasks) t.lines.rim = &rim;
    add(to, infill::loops(parts.sparse, tasks), lines, Feature::infill);
    for (std::size_t k = 0; k < parts.bridge.size(); ++k)
        add_rows(to, parts.bridge[k], parts.direction[k], w, tolerance);
    for (const Loops& part : parts.solid) add(to, rings::lanes(part, {.width = solid, .tolerance = tolerance}), 0);
}

// Adds the curves of a piece inside walls of `depth` mm: the walls of the piece and what lies inside them.
void add_piece(LooseCurves& to, const RegionPiece& piece, const Region& r, double depth, double tolerance) {
    if (piece.walls == 0) return add_inside(to, piece.where, r, depth, piece.width, piece.solid, tolerance);
    const auto walls = rings::first_lanes(
        piece.where, {.width = piece.width, .most = static_cast<int>(piece.walls), .tolerance = tolerance});
    add(to, walls.lanes, piece.walls, Feature::wall);
    for (const Loops& rest : walls.rest)
        add_inside(to, rest, r, depth + piece.walls * piece.width, piece.width, piece.solid, tolerance);
}

// True if an area that stays empty covers everything inside the walls, however narrow that is.
bool stays_empty(const Loops& rest, const Region& r) {
    return std::any_of(r.areas.begin(), r.areas.end(), [&](const Area& a) {
        return a.kind == AreaKind::sparse && a.spacing >= infill::kHollow && polygon::subtract(rest, a.loops).empty();
    });
}

// All closed curves of the region, not joined yet.
LooseCurves closed_curves(const Region& r, double w, double tolerance) {
    LooseCurves out;
    if (!has(r, AreaKind::sparse) && !has(r, AreaKind::bridge) && !has(r, AreaKind::zone)) {
        add(out, rings::lanes(r.loops, {.width = w, .tolerance = tolerance}), r.walls);
        return out;
    }
    const auto walls =
        rings::first_lanes(r.loops, {.width = w, .most = static_cast<int>(r.walls), .tolerance = tolerance});
    add(out, walls.lanes, r.walls);
    const double depth = r.walls * w;
    for (const Loops& rest : walls.rest)
        if (stays_empty(rest, r))
            continue;
        else if (!has(r, AreaKind::zone))
            add_inside(out, rest, r, depth, w, w, tolerance);
        else
            for (const RegionPiece& piece : pieces(polygon::simplify(rest, kTolerance), r, w))
                add_piece(out, piece, r, depth, tolerance);
    return out;
}

// How beads are carried over the air that bridges of the region span; empty without bridges. The rim of the air is two
// beads wide: there are the turns of rows that end at a wall.
fill::join::Hanging hanging(const Region& r, double w) {
    Loops all;
    for (const Area& a : r.areas)
        if (a.kind == AreaKind::bridge) all.add(a.loops);
    if (all.empty()) return {};
    const polygon::InsideTest inside(all), deep(polygon::offset(all, -2 * w, kTolerance));
    return [inside, deep](Vec2 p) { return !inside(p) ? 0 : deep(p) ? fill::join::kHangsMost : 1; };
}

// The greatest ratio of bead widths in a region. A machine's beads differ by far less; where two beads meet, one tapers
// to the other in as many pieces as the ratio asks for.
constexpr double kMostWider = 100;

// Throws Error(bad_input) for areas with too many lines, with lines nearer than a bead, or with widths too different to
// be joined.
void check_densities(const Region& r, const Widths& width) {
    if (width.widest > kMostWider * width.narrowest)
        throw Error(Exit::bad_input, "cannot fill region '" + std::to_string(r.id) + "': its beads are " +
                                         shortest_text(width.narrowest) + " to " + shortest_text(width.widest) +
                                         " mm wide; give widths that differ by at most a factor of 100");
    for (const Area& a : r.areas) {
        const double area = polygon::signed_area(a.loops);
        if (a.kind == AreaKind::zone) check_density(area, a.width, Exit::bad_input, "the bead width of a zone");
        if (a.solid > 0) check_density(area, a.solid, Exit::bad_input, "the bead width of solid parts");
        if (a.kind == AreaKind::sparse && a.width > 0)
            check_density(area, a.width, Exit::bad_input, "the bead width of an area");
        if (a.kind != AreaKind::sparse) continue;
        check_spacing(a.spacing, width.narrowest, Exit::bad_input, "the spacing of an area");
        check_density(area, a.spacing, Exit::bad_input, "the spacing of an area");
        if (a.gap > 0) check_spacing(a.gap, width.narrowest, Exit::bad_input, "the gap of an area");
    }
}

} // namespace

toolpath::RegionPaths fill(const Region& r, const Options& o, Notes& notes) {
    const Widths width = widths(r, o.bead_width);
    check_densities(r, width);
    toolpath::RegionPaths out;
    toolpath::identify(out, r);
    const std::size_t first = notes.size();
    const auto hung = hanging(r, width.widest);
    const auto inside = fill::Rounded::inside; // outer walls are visible and keep sharp corners
    LooseCurves loose;
    // the numbers of crossings and of curves
    constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
    std::pair fewest{kMost, kMost};
    for (const fill::join::Attempt& how : fill::join::kAttempts) {
        const double tolerance = how.share * kTolerance;
        LooseCurves parts = closed_curves(r, o.bead_width, tolerance);
        auto curves = fill::finished(parts.rings, r.loops,
                                     {.bead_width = width.narrowest,
                                      .tolerance = kOfSkins * tolerance,
                                      .wind = how.wind,
                                      .corners = how.round ? inside : fill::Rounded::nowhere,
                                      .hung = hung,
                                      .widest = width.widest});
        const double left = fill::leave_tiny(curves, width.narrowest);
        const std::pair faults{toolpath::part_crossings(curves, width.widest).size(), curves.size()};
        if (faults >= fewest) continue;
        fewest = faults;
        loose = std::move(parts);
        out.curves = std::move(curves);
        out.unplaced = left;
        if (fewest == std::pair<std::size_t, std::size_t>{0, 1}) break;
    }
    if (fewest.first > 0) fill::join::uncross(out.curves, width.widest, notes);
    tell_features(r, loose, width.widest, out.curves);
    if (r.is == polygon::RegionClass::part && o.overhang_shares) measure_overhangs(r, o.bead_width, out.curves);
    if (r.is == polygon::RegionClass::part) mark_walls_over_air(r, o.bead_width, out.curves);
    fill::join::note_unjoined(out.curves, notes);
    for (std::size_t i = first; i < notes.size(); ++i) notes[i].layer = r.layer;
    return out;
}

} // namespace filum::fill::hollow
