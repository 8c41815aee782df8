#include "regions/air.hpp"

#include "base/number.hpp"
#include "geom/segment.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"
#include "regions/farthest.hpp"
#include "regions/inradius.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace filum::regions {

namespace {

using geom::Box2;
using geom::Vec2;
using polygon::Loops;
using polygon::Region;

constexpr double kArc = 1.0 / 32; // of the bead width; tolerance of the arcs around corners of the layer below
constexpr int kWays = 36;         // directions tried for a bridge: every 5 degrees

constexpr double kTouch = 2 * polygon::kGridStep; // mm; rounding of pieces

Box2 grown(Box2 box, double by) {
    box.lo = box.lo - Vec2{by, by};
    box.hi = box.hi + Vec2{by, by};
    return box;
}

bool holds(const Box2& box, const Box2& inner) {
    return box.lo.x <= inner.lo.x && box.lo.y <= inner.lo.y && box.hi.x >= inner.hi.x && box.hi.y >= inner.hi.y;
}

// The part of the lower regions in the box; all of their loops if these lie in the box anyway.
Loops within(std::span<const Region> lower, const Box2& box) {
    Loops out, frame;
    for (const Region& l : lower)
        if (meet(l.box, box)) out.add(l.loops);
    const Box2 all = polygon::bounds(out);
    if (out.empty() || holds(box, all)) return out;
    frame.add(std::vector<Vec2>{box.lo, {box.hi.x, box.lo.y}, box.hi, {box.lo.x, box.hi.y}});
    return polygon::intersect(out, frame);
}

// The part of `area` that is farther than `r` from `lower`.
Loops farther(const Loops& area, const Loops& lower, double r, double arc) {
    return polygon::subtract(area, polygon::offset(lower, r, arc));
}

// The length of the shortest straight way through p that begins and ends at the layer below, mm; 0 if there is none.
double bridge_over(Vec2 p, std::span<const Region> lower) {
    double best = 0;
    for (int k = 0; k < kWays; ++k) {
        const double a = std::numbers::pi * k / kWays;
        double way = 0;
        for (const double sign : {1.0, -1.0}) {
            const Vec2 d{sign * std::cos(a), sign * std::sin(a)};
            double hit = std::numeric_limits<double>::infinity();
            for (const Region& r : lower)
                for (std::size_t l = 0; l < r.loops.size(); ++l)
                    for (std::size_t i = 0, n = r.loops[l].size(); i < n; ++i)
                        if (const auto h = geom::ray_parameters(p, d, r.loops[l][i], r.loops[l][(i + 1) % n]))
                            hit = std::min(hit, h->t);
            way += hit;
        }
        if (std::isfinite(way) && (best == 0 || way < best)) best = way;
    }
    return best;
}

// The region in which a piece lies: the one whose outline holds one of its points. If they are all on outlines, it is
// the region whose box is nearest to the first point.
std::size_t owner(std::span<const Region> upper, const std::vector<std::size_t>& among, const Loops& piece) {
    const Box2 box = polygon::bounds(piece);
    for (const std::size_t i : among)
        if (holds(grown(upper[i].box, kTouch), box))
            for (std::size_t k = 0; k < piece[0].size(); ++k)
                if (polygon::contains(upper[i].loops, piece[0][k])) return i;
    const Vec2 p = piece[0][0];
    const auto far = [&](std::size_t i) { return geom::distance(upper[i].box, Box2{p, p}); };
    return *std::min_element(among.begin(), among.end(), [&](std::size_t a, std::size_t b) { return far(a) < far(b); });
}

} // namespace

void hang(std::span<Region> upper, std::span<const Region> lower, std::span<const double> covered,
          const CarrierOptions& how, Air& air) {
    const double allowed = how.bead_width / 2, arc = kArc * how.bead_width;
    const double dot = std::numbers::pi * allowed * allowed; // mm2, least area of a bead; corners and tips are smaller
    Loops free;
    std::vector<std::size_t> among;
    Box2 box;
    for (std::size_t i = 0; i < upper.size(); ++i) {
        upper[i].unsupported = 0;
        if (upper[i].area - covered[i] < dot) continue;
        free.add(upper[i].loops);
        among.push_back(i);
        box.add(upper[i].box.lo);
        box.add(upper[i].box.hi);
    }
    if (among.empty()) return;
    // A piece lies in a region with a box around its own box, and rarely in another one than the smallest.
    std::ranges::sort(among, {}, [&](std::size_t i) {
        const geom::Vec2 size = upper[i].box.hi - upper[i].box.lo;
        return std::pair{size.x * size.y, i};
    });
    Loops counted; // the pieces that count
    const Loops under = within(lower, grown(box, 2 * allowed));
    for (const Loops& piece : polygon::split(farther(free, under, allowed, arc)).part) {
        const double area = polygon::signed_area(piece);
        const std::size_t of = owner(upper, among, piece);
        if (covered[of] > 0 && area < dot) continue;
        if (inradius_bound(piece, how.hairline / 2, how.hairline / 2) == 0) continue;
        upper[of].unsupported += area;
        air.area += area;
        counted.add(piece);
    }
    air.layers += counted.empty() ? 0 : 1;
    const auto worst = farthest(counted, lower, std::max(air.reach, allowed), how.hairline);
    if (!worst || worst->reach <= air.reach) return;
    air.reach = worst->reach;
    air.at = worst->at;
    air.layer = upper[among.front()].layer;
    air.bridge = bridge_over(air.at, lower);
}

void add(Air& all, const Air& further) {
    const double area = all.area + further.area;
    const std::size_t layers = all.layers + further.layers;
    if (further.reach > all.reach) all = further;
    all.area = area;
    all.layers = layers;
}

bool of_air(NoteCode code) {
    return code == NoteCode::overhang || code == NoteCode::overhang_bridge || code == NoteCode::overhang_floating;
}

std::optional<Note> note(const Air& air) {
    if (air.layers == 0) return std::nullopt;
    Note out{NoteCode::overhang, air.area, air.layers, air.layer, air.at.x, air.at.y};
    out.detail = fixed_text(air.reach, 1) + " mm";
    if (!std::isfinite(air.reach)) {
        out.code = NoteCode::overhang_floating;
        out.detail.clear();
    } else if (air.bridge > 0) {
        out.code = NoteCode::overhang_bridge;
        out.detail = fixed_text(air.bridge, 1) + " mm";
    }
    return out;
}

} // namespace filum::regions
