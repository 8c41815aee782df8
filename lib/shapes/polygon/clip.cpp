#include "polygon/clip.hpp"

#include "base/error.hpp"
#include "polygon/clusters.hpp"
#include "polygon/cut.hpp"
#include "polygon/moved_outlines.hpp"
#include "polygon/simple.hpp"
#include "polygon/tiles.hpp"
#include "polygon/touches.hpp"

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::polygon {

namespace {

namespace cl = ClipperLib;

// mm; loops that are farther apart do not touch after rounding to the grid.
constexpr double kApart = 4 * kGridStep;

cl::Paths to_clipper(const Loops& a) {
    cl::Paths out(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        out[i].reserve(a[i].size());
        for (const Vec2 p : a[i]) out[i].emplace_back(std::llround(p.x * kGridPerMm), std::llround(p.y * kGridPerMm));
    }
    return out;
}

void append(Loops& out, const cl::Path& path) {
    if (path.size() < 3) return;
    for (const auto& p : path)
        out.points.push_back({static_cast<double>(p.X) / kGridPerMm, static_cast<double>(p.Y) / kGridPerMm});
    out.close();
}

Loops from_clipper(const cl::Paths& paths) {
    Loops out;
    for (const auto& path : paths) append(out, path);
    return out;
}

cl::PolyFillType fill_type(Fill rule) {
    if (rule == Fill::even_odd) return cl::pftEvenOdd;
    return rule == Fill::positive ? cl::pftPositive : cl::pftNonZero;
}

// Strict mode compares all pairs of points of each loop. Up to this many points a loop takes less than 0.1 s.
constexpr std::size_t kMostStrict = 8000;

// Whether strict mode is worth its time. It moves and splits some loops that touch others, and leaves most: callers
// must accept loops that touch each other in any case.
bool strict_is_fast(const Loops& a) {
    for (std::size_t l = 0; l < a.size(); ++l)
        if (a[l].size() > kMostStrict) return false;
    return true;
}

Loops combine_tile(cl::ClipType kind, std::span<const Loops> in, Fill rule, bool strict) {
    cl::Clipper clipper;
    clipper.AddPaths(to_clipper(in[0]), cl::ptSubject, true);
    if (in.size() > 1) clipper.AddPaths(to_clipper(in[1]), cl::ptClip, true);
    cl::Paths out;
    clipper.Execute(kind, out, fill_type(rule), fill_type(rule));
    Loops result = from_clipper(out);
    if (!strict || is_simple(result)) return result;
    Loops parted = parted_at_touches(result);
    if (is_simple(parted) || !strict_is_fast(result)) return parted;
    clipper.StrictlySimple(true); // different loops touch each other
    clipper.Execute(kind, out, fill_type(rule), fill_type(rule));
    return from_clipper(out);
}

Loops combine(cl::ClipType kind, std::span<const Loops> in, Fill rule, bool strict = true) {
    try {
        return clustered(in, kApart, [&](std::span<const Loops> cluster) {
            return tiled(cluster, 0,
                         [&](std::span<const Loops> tile) { return combine_tile(kind, tile, rule, strict); });
        });
    } catch (const cl::clipperException& e) {
        throw Error(Exit::bad_input, std::string("cannot combine outlines: ") + e.what());
    }
}
Loops combine(cl::ClipType kind, const Loops& a, const Loops& b, Fill rule, bool strict = true) {
    const Loops both[] = {a, b};
    return combine(kind, both, rule, strict);
}

// The loops without those that an offset by `delta` closes. An area that holds no circle of radius |delta| vanishes
// when it shrinks, as does a hole of such an area when it is filled. Moved past its middle, a small loop of many points
// would cross itself as often as it has pairs of points.
Loops without_closing(const Loops& tile, double delta) {
    const double least = std::numbers::pi * delta * delta; // mm2, of a circle
    Loops out;
    for (std::size_t l = 0; l < tile.size(); ++l) {
        const double area = polygon::signed_area(tile[l]);
        if (delta < 0 ? area <= 0 || area >= least : area >= 0 || -area >= least) out.add(tile[l]);
    }
    return out;
}

// The offset of a tile: the places around which the moved outlines wind counter-clockwise.
Loops offset_tile(const Loops& tile, double delta, double arc_tolerance) {
    const Loops moving = without_closing(tile, delta);
    if (moving.empty()) return {};
    cl::Clipper clipper;
    clipper.AddPaths(to_clipper(moved_outlines(moving, delta, arc_tolerance)), cl::ptSubject, true);
    cl::Paths out;
    clipper.Execute(cl::ctUnion, out, cl::pftPositive, cl::pftPositive);
    return from_clipper(out);
}

struct PartKey {
    Vec2 key;
    std::size_t part;
};

// Adds the outer node and its holes as one part, then the outer nodes inside the holes.
void collect(const cl::PolyNode& outer, int parent, Parts& out) {
    Loops part;
    append(part, outer.Contour);
    if (part.empty()) return;
    for (const auto* hole : outer.Childs) append(part, hole->Contour);
    const int self = static_cast<int>(out.part.size());
    out.part.push_back(std::move(part));
    out.parent.push_back(parent);
    for (const auto* hole : outer.Childs)
        for (const auto* island : hole->Childs) collect(*island, self, out);
}

Vec2 lowest_left(std::span<const Vec2> loop) {
    return *std::min_element(loop.begin(), loop.end(),
                             [](Vec2 a, Vec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
}

// The loops, rounded to the grid of Boolean results.
Loops on_grid(Loops a) {
    for (Vec2& p : a.points)
        p = {static_cast<double>(std::llround(p.x * kGridPerMm)) / kGridPerMm,
             static_cast<double>(std::llround(p.y * kGridPerMm)) / kGridPerMm};
    return a;
}

// The parts of a simple area, in the order of their outer loops. `within` is its nesting().
Parts parts_of_simple(const Loops& area, const std::vector<int>& within) {
    const Loops a = on_grid(area);
    Parts out;
    std::vector<int> part_of(a.size(), -1); // the part of each loop
    for (std::size_t l = 0; l < a.size(); ++l) {
        if (signed_area(a[l]) < 0) continue;
        part_of[l] = static_cast<int>(out.part.size());
        out.part.emplace_back();
        out.part.back().add(a[l]);
    }
    for (std::size_t l = 0; l < a.size(); ++l) {
        if (part_of[l] >= 0) continue; // an outer loop
        part_of[l] = part_of[static_cast<std::size_t>(within[l])];
        out.part[static_cast<std::size_t>(part_of[l])].add(a[l]);
    }
    for (std::size_t l = 0; l < a.size(); ++l)
        if (signed_area(a[l]) >= 0)
            out.parent.push_back(within[l] < 0 ? -1 : part_of[static_cast<std::size_t>(within[l])]);
    return out;
}

// The parts of any loops. Clipper does what a union does not mend.
Parts parts_of_any(const Loops& a) {
    cl::PolyTree tree;
    try {
        const Loops parted = unite(a);
        if (const auto within = nesting(parted)) return parts_of_simple(parted, *within);
        if (const auto within = nesting_of_touching(parted)) return parts_of_simple(parted, *within);
        cl::Clipper clipper;
        clipper.StrictlySimple(strict_is_fast(parted));
        clipper.AddPaths(to_clipper(parted), cl::ptSubject, true);
        clipper.Execute(cl::ctUnion, tree, cl::pftNonZero, cl::pftNonZero);
    } catch (const cl::clipperException& e) {
        throw Error(Exit::bad_input, std::string("cannot split outlines: ") + e.what());
    }
    Parts out;
    for (const auto* outer : tree.Childs) collect(*outer, -1, out);
    return out;
}

// The parts, sorted by the lowest-left vertices of the outer loops.
Parts ordered(Parts found) {
    std::vector<PartKey> order;
    for (std::size_t i = 0; i < found.part.size(); ++i) order.push_back({lowest_left(found.part[i][0]), i});
    std::stable_sort(order.begin(), order.end(), [](const PartKey& l, const PartKey& r) {
        return l.key.y < r.key.y || (l.key.y == r.key.y && l.key.x < r.key.x);
    });
    std::vector<int> place(found.part.size());
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i].part] = static_cast<int>(i);
    Parts out;
    for (const auto& o : order) {
        out.part.push_back(std::move(found.part[o.part]));
        const int parent = found.parent[o.part];
        out.parent.push_back(parent < 0 ? -1 : place[static_cast<std::size_t>(parent)]);
    }
    return out;
}

// The point of a stretch of a loop that is farthest from its chord, and its squared distance.
struct Farthest {
    std::size_t at = 0;
    double distance2 = 0;
};

// The farthest of the points in (from, to) from the chord between i and j.
Farthest farthest(std::span<const Vec2> loop, std::size_t i, std::size_t j, std::size_t from, std::size_t to) {
    const std::size_t n = loop.size();
    const Vec2 a = loop[i % n], d = loop[j % n] - a;
    const double l2 = geom::norm2(d);
    Farthest out;
    for (std::size_t k = from + 1; k < to; ++k) {
        const Vec2 q = loop[k] - a;
        const double t = l2 > 0 ? std::clamp(geom::dot(q, d) / l2, 0.0, 1.0) : 0.0;
        const double e = geom::norm2(q - t * d);
        if (e > out.distance2) out = {k, e};
    }
    return out;
}

// Keeps the points of loop[first..last] that are farther from the chord than the tolerance. Iterative, because
// recursion on long loops could be too deep. A long stretch is split near its middle, so that the teeth of a comb are
// not split off one by one.
void keep_far_points(std::span<const Vec2> loop, std::size_t first, std::size_t last, double tolerance,
                     std::vector<char>& keep) {
    constexpr std::size_t kLong = 2000; // points
    std::vector<std::pair<std::size_t, std::size_t>> pending{{first, last}};
    while (!pending.empty()) {
        const auto [i, j] = pending.back();
        pending.pop_back();
        const std::size_t margin = j - i > kLong ? (j - i) / 3 : 0;
        Farthest found = farthest(loop, i, j, i + margin, j - margin);
        if (margin > 0 && found.distance2 <= tolerance * tolerance) found = farthest(loop, i, j, i, j);
        if (found.distance2 <= tolerance * tolerance) continue;
        keep[found.at] = 1;
        pending.emplace_back(i, found.at);
        pending.emplace_back(found.at, j);
    }
}

} // namespace

Loops unite(const Loops& a, Fill rule) { return combine(cl::ctUnion, {&a, 1}, rule); }
Loops unite(const Loops& a, const Loops& b, Fill rule) { return combine(cl::ctUnion, a, b, rule); }
Loops unite_by_halves(const Loops& a) {
    constexpr std::size_t kFew = 1000; // points that one union takes in about a millisecond
    if (a.points.size() <= kFew || a.size() < 2) return unite(a);
    Loops half[2];
    for (std::size_t l = 0; l < a.size(); ++l) half[l < a.size() / 2 ? 0 : 1].add(a[l]);
    return unite(unite_by_halves(half[0]), unite_by_halves(half[1]));
}
Loops intersect(const Loops& a, const Loops& b, Fill rule) { return combine(cl::ctIntersection, a, b, rule); }
Loops intersect_touching(const Loops& a, const Loops& b, Fill rule) {
    return combine(cl::ctIntersection, a, b, rule, false);
}
Loops subtract(const Loops& a, const Loops& b, Fill rule) { return combine(cl::ctDifference, a, b, rule); }

Loops within_box(const Loops& a, const Box2& box) {
    if (auto part = clipped_simple(a, box)) return std::move(*part);
    Loops frame;
    frame.add(std::vector<Vec2>{box.lo, {box.hi.x, box.lo.y}, box.hi, {box.lo.x, box.hi.y}});
    return intersect(a, frame);
}

Loops offset(const Loops& a, double delta, double arc_tolerance) {
    if (a.empty()) return {};
    try {
        const double reach = std::abs(delta) + arc_tolerance;
        return clustered({&a, 1}, 2 * reach, [&](std::span<const Loops> cluster) { // both outlines move
            return tiled(cluster, reach,
                         [&](std::span<const Loops> tile) { return offset_tile(tile[0], delta, arc_tolerance); });
        });
    } catch (const cl::clipperException& e) {
        throw Error(Exit::bad_input, std::string("cannot offset outlines: ") + e.what());
    }
}

Loops opened(const Loops& a, double radius, double arc_tolerance) {
    return offset(offset(a, -radius, arc_tolerance), radius, arc_tolerance);
}

Loops opened_difference(const Loops& a, const Loops& b, double radius, double arc_tolerance) {
    Loops core = offset(a, -radius, arc_tolerance);
    if (!core.empty() && !b.empty()) core = subtract(core, offset(b, radius, arc_tolerance));
    return offset(core, radius, arc_tolerance);
}

Loops closed(const Loops& a, double radius, double arc_tolerance) {
    return offset(offset(a, radius, arc_tolerance), -radius, arc_tolerance);
}

Loops around(std::span<const Vec2> line, double radius, double arc_tolerance) {
    try {
        cl::ClipperOffset offsetter(2.0, arc_tolerance * kGridPerMm);
        cl::Path path;
        for (const Vec2 p : line) path.emplace_back(std::llround(p.x * kGridPerMm), std::llround(p.y * kGridPerMm));
        offsetter.AddPath(path, cl::jtRound, cl::etOpenRound);
        cl::Paths out;
        offsetter.Execute(out, radius * kGridPerMm);
        return from_clipper(out);
    } catch (const cl::clipperException& e) {
        throw Error(Exit::bad_input, std::string("cannot widen a line: ") + e.what());
    }
}

Parts split(const Loops& a) {
    const auto within = nesting(a);
    return ordered(within ? parts_of_simple(a, *within) : parts_of_any(a));
}

Loops simplify(const Loops& a, double tolerance) {
    Loops out;
    std::vector<char> keep;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const auto loop = a[i];
        if (loop.size() < 3) continue;
        std::size_t far = 0; // fixed points: the first, and the one farthest from it
        for (std::size_t k = 1; k < loop.size(); ++k)
            if (geom::norm2(loop[k] - loop[0]) > geom::norm2(loop[far] - loop[0])) far = k;
        if (far == 0) continue;
        keep.assign(loop.size(), 0);
        keep[0] = keep[far] = 1;
        keep_far_points(loop, 0, far, tolerance, keep);
        keep_far_points(loop, far, loop.size(), tolerance, keep);
        const std::size_t before = out.points.size();
        for (std::size_t k = 0; k < loop.size(); ++k)
            if (keep[k]) out.points.push_back(loop[k]);
        if (out.points.size() - before < 3)
            out.points.resize(before);
        else
            out.close();
    }
    return out;
}

Loops without_flat_starts(const Loops& a) {
    const auto flat = [](std::span<const Vec2> loop) {
        if (loop.size() < 4) return false;
        const Vec2 d = loop[1] - loop.back(), p = loop[0] - loop.back();
        const double t = geom::dot(p, d), l2 = geom::norm2(d);
        return t > 0 && t < l2 && std::abs(geom::cross(d, p)) < kGridStep * std::sqrt(l2);
    };
    Loops out;
    for (std::size_t l = 0; l < a.size(); ++l) out.add(flat(a[l]) ? a[l].subspan(1) : a[l]);
    return out;
}

} // namespace filum::polygon
