#include "fill/scaffold/scaffold.hpp"

#include "fill/join/cycle.hpp"
#include "fill/join/double_spiral.hpp"
#include "fill/rings/lanes.hpp"
#include "fill/rings/wall_lanes.hpp"
#include "fill/scaffold/strand_bead.hpp"
#include "geom/segment.hpp"
#include "polygon/clip.hpp"
#include "polygon/inset.hpp"
#include "polygon/stretches.hpp"
#include "toolpath/curve_place.hpp"
#include "toolpath/merge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::fill::scaffold {

using geom::Box2;
using toolpath::kLeastMove; // mm: a strand on the very edge of the area moves inwards by this

namespace {

constexpr double kMostRound = 2; // bead widths: the largest radius of a turn

// The heights of the strands in `part`, in the frame where they run along x.
std::vector<double> heights(const Loops& part, const Loops& frame, const ScaffoldOptions& o) {
    const auto whole = polygon::bounds(frame), box = polygon::bounds(part);
    const double room = std::max(0.0, whole.hi.y - whole.lo.y - (1 + 2 * o.rings) * o.bead_width);
    const double span = std::floor(room / o.spacing + 1e-6) * o.spacing;
    const double base = (whole.lo.y + whole.hi.y - span) / 2 + o.shift * o.spacing;
    std::vector<double> out;
    for (double k = std::ceil((box.lo.y - kLeastMove - base) / o.spacing);
         base + k * o.spacing <= box.hi.y + kLeastMove; k += 1)
        out.push_back(std::clamp(base + k * o.spacing, box.lo.y + kLeastMove, box.hi.y - kLeastMove));
    if (out.empty()) out.push_back((box.lo.y + box.hi.y) / 2);
    return out;
}

// The strands of `part` if their spacing changes within the layer.
StrandGraph bent_strands(const Loops& part, const Loops& frame, std::optional<Vec2> from, const ScaffoldOptions& o) {
    const Box2 whole = polygon::bounds(frame);
    Box2 box = polygon::bounds(part);
    box.add(whole.lo);
    box.add(whole.hi);
    // The frame's middle stays in the middle of the box, so that line 0 is the same in all layers.
    const Vec2 middle = geom::lerp(whole.lo, whole.hi, 0.5);
    box.add(middle + (middle - box.lo));
    box.add(middle + (middle - box.hi));
    const Vec2 u{std::cos(o.angle), std::sin(o.angle)};
    const Fronts fronts(box, o.bead_width / 2, [&](Vec2 p) {
        return o.spacing_at({p.x * u.x - p.y * u.y, p.x * u.y + p.y * u.x});
    });
    const double margin = (0.5 + o.rings) * o.bead_width;
    double low = 0, high = 0; // levels between which the strands of the frame lie
    for (double x = whole.lo.x; x <= whole.hi.x; x += fronts.column_width()) {
        low = std::min(low, fronts.level({x, std::min(middle.y, whole.lo.y + margin)}));
        high = std::max(high, fronts.level({x, std::max(middle.y, whole.hi.y - margin)}));
    }
    const double base = (low + high - std::floor(high - low + 1e-6)) / 2 + o.shift;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest; // of the part
    for (const Vec2 p : part.points) {
        const double level = fronts.level(p);
        lowest = std::min(lowest, level);
        highest = std::max(highest, level);
    }
    std::vector<double> levels;
    for (double k = std::ceil(lowest - base); base + k <= highest; k += 1) levels.push_back(base + k);
    if (levels.empty()) levels.push_back((lowest + highest) / 2);
    return bent_strand_graph(part, fronts, levels, o.bead_width, from);
}

// Adds the curves of one connected part: its strands and the turns between them.
void fill_with_strands(const Loops& part, const Loops& frame, std::optional<Vec2> from, const ScaffoldOptions& o,
                       std::vector<toolpath::Curve>& out, double& again) {
    const double w = o.bead_width;
    StrandGraph graph =
        o.spacing_at ? bent_strands(part, frame, from, o) : strand_graph(part, heights(part, frame, o), w, from);
    if (graph.strands == 0) {
        const auto box = polygon::bounds(part);
        graph = strand_graph(part, std::vector{(box.lo.y + box.hi.y) / 2}, kLeastMove, from);
    }
    const StrandWalk walk = strand_walk(graph);
    const Passes times = passes(graph, walk);
    again += walk.again;
    for (const auto& trail : walk.trails)
        out.push_back(strand_bead(graph, trail, times, w, std::min(o.spacing / 2, kMostRound * w)));
}

double distance_to(const Loops& part, Vec2 p) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t l = 0; l < part.size(); ++l)
        for (std::size_t i = 0; i < part[l].size(); ++i)
            least = std::min(least, geom::point_segment_distance(part[l][i], part[l][(i + 1) % part[l].size()], p));
    return least;
}

std::vector<geom::Segment> segments(const std::vector<toolpath::Curve>& curves) {
    std::vector<geom::Segment> out;
    for (const auto& c : curves)
        for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i)
            out.push_back({c.points[i], c.points[(i + 1) % c.points.size()]});
    return out;
}

// Lets the curve begin at `from`, within the part, if its start is more than a bead away. The part grows there from
// layer to layer. False if a bead lies between.
bool begin_at(toolpath::Curve& curve, Vec2 from, const Loops& part, double width) {
    const Vec2 start = curve.points.front();
    if (geom::distance(from, start) <= width || !polygon::contains(part, from)) return true;
    const Vec2 near =
        geom::lerp(start, from, kLeastMove / geom::distance(from, start)); // the start itself is no obstacle
    const auto own = segments({curve});
    if (std::any_of(own.begin(), own.end(), [&](const auto& s) { return geom::cross_properly(from, near, s.a, s.b); }))
        return false;
    curve.points.insert(curve.points.begin(), from);
    if (curve.width.size() > 1) curve.width.insert(curve.width.begin(), curve.width.front());
    return true;
}

// The places on the boundary to the left and right of p, the nearer one first.
std::vector<Vec2> beside(const Loops& part, Vec2 p) {
    std::vector<Vec2> out;
    double left = -std::numeric_limits<double>::infinity(), right = -left;
    for (std::size_t l = 0; l < part.size(); ++l)
        for (std::size_t i = 0; i < part[l].size(); ++i) {
            const Vec2 a = part[l][i], b = part[l][(i + 1) % part[l].size()];
            if ((a.y <= p.y) == (b.y <= p.y)) continue;
            const double x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
            if (x < p.x) left = std::max(left, x);
            if (x >= p.x) right = std::min(right, x);
        }
    for (const double x : {left, right})
        if (std::isfinite(x)) out.push_back({x, p.y});
    if (out.size() == 2 && right - p.x < p.x - left) std::swap(out[0], out[1]);
    return out;
}

// Leads the end of the curve back over itself to the first place within `area`, half as wide there both times. Does
// nothing if it ends within, or is nowhere within. Returns the length in mm.
double lead_back(toolpath::Curve& curve, const Loops& area, double width) {
    if (curve.closed || polygon::contains(area, curve.points.back())) return 0;
    const double taper = rings::kMostOff * width;
    double back = 0;
    for (std::size_t i = curve.points.size() - 1; i > 0; --i) {
        const Vec2 a = curve.points[i], b = curve.points[i - 1];
        const double length = geom::distance(a, b);
        const auto parts = static_cast<std::size_t>(std::ceil(4 * length / width));
        for (std::size_t k = 1; k <= parts; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(parts);
            const Vec2 q = geom::lerp(a, b, t);
            if (!polygon::contains(area, q)) continue;
            if (curve.width.size() == 1) curve.width.resize(curve.points.size(), curve.width[0]);
            const auto at = static_cast<std::ptrdiff_t>(i);
            curve.points.insert(curve.points.begin() + at, geom::lerp(q, a, std::min(1.0, taper / (t * length)) / 2));
            curve.width.insert(curve.width.begin() + at, curve.width[i]);
            curve.points.insert(curve.points.begin() + at, q);
            curve.width.insert(curve.width.begin() + at, curve.width[i]);
            for (std::size_t j = i + 1; j < curve.width.size(); ++j) curve.width[j] /= 2;
            for (std::size_t j = curve.points.size() - 1; j-- > i;) curve.add(curve.points[j], curve.width[i + 1]);
            return back + t * length;
        }
        back += length;
    }
    return 0;
}

// Adds the curves of the part where the nozzle comes from below at `from`.
void begin_within(const Loops& part, const Loops& frame, Vec2 from, const ScaffoldOptions& o,
                  std::vector<toolpath::Curve>& out, double& again) {
    fill_with_strands(part, frame, from, o, out, again);
    if (out.empty() || begin_at(out.front(), from, part, o.bead_width)) return;
    for (const Vec2 side : beside(part, from)) {
        std::vector<toolpath::Curve> other;
        double twice = 0;
        fill_with_strands(part, frame, side, o, other, twice);
        if (other.empty() || !begin_at(other.front(), from, part, o.bead_width)) continue;
        out = std::move(other);
        again = twice;
        return;
    }
}

// Extends an open curve, too short for a link beside it, from its end to a ring nearby and once around that. False if
// the ring is too far away or a curve lies between.
bool lead_on(toolpath::Curve& open, const toolpath::Curve& ring, const std::vector<geom::Segment>& all, double width) {
    const auto sums = toolpath::arc_lengths(ring);
    const Vec2 end = open.points.back();
    const toolpath::CurvePlace at = toolpath::nearest_place(ring, sums, end);
    if (at.off > join::kNeighbourReach * width) return false;
    const Vec2 a = geom::lerp(end, at.point, join::kLinkEnd), b = geom::lerp(at.point, end, join::kLinkEnd);
    if (std::any_of(all.begin(), all.end(), [&](const auto& s) { return geom::cross_properly(a, b, s.a, s.b); }))
        return false;
    const double gap = std::min(width, sums.back()) / 4; // two round ends fill it
    toolpath::add_stretch(ring, at,
                          toolpath::place_at(ring, sums, std::fmod(at.along + sums.back() - gap, sums.back())), open);
    return true;
}

// Joins the rings of the region to the curves, so that they share strokes.
std::vector<toolpath::Curve> with_rings(std::vector<toolpath::Curve> curves, const Loops& region,
                                        const ScaffoldOptions& o, Notes& notes) {
    rings::Rings lines;
    for (toolpath::Curve& c : curves) {
        if (c.width.size() == 1) c.width.resize(c.points.size(), c.width[0]);
        lines.add(c, 0);
    }
    lines.add(rings::lanes(region, {.width = o.bead_width, .most = o.rings}));
    auto out = join::join_rings(lines, o.bead_width, region);
    const auto open = out.begin() + static_cast<std::ptrdiff_t>(curves.size());
    for (auto ring = open; ring != out.end();) {
        const auto all = segments(out);
        if (std::any_of(out.begin(), open, [&](auto& c) { return lead_on(c, *ring, all, o.bead_width); })) {
            ring = out.erase(ring);
            continue;
        }
        notes.push_back({NoteCode::ring_unjoined, 1, 1, -1, ring->points[0].x, ring->points[0].y});
        ++ring;
    }
    return out;
}

} // namespace

std::vector<toolpath::Curve> scaffold(const Loops& region, const Loops& frame, const ScaffoldOptions& o, Notes& notes) {
    const double w = o.bead_width;
    const Loops first = polygon::inset(region, w / 2),
                area = polygon::rotated(polygon::inset(region, (o.rings + 0.5) * w), -o.angle);
    const Loops turned = polygon::rotated(frame, -o.angle);
    std::vector<Vec2> at;
    if (o.from) at.push_back(*o.from);
    polygon::rotate(at, -o.angle);
    std::vector<toolpath::Curve> out;
    double again = 0;
    // the part nearest to the nozzle first, then always the nearest one
    for (auto parts = polygon::split(area).part; !parts.empty();) {
        auto next = parts.begin();
        if (!at.empty())
            next = std::min_element(parts.begin(), parts.end(), [&](const Loops& a, const Loops& b) {
                return distance_to(a, at[0]) < distance_to(b, at[0]);
            });
        if (out.empty() && o.from)
            begin_within(*next, turned, at[0], o, out, again);
        else
            fill_with_strands(*next, turned, at.empty() ? std::nullopt : std::optional(at[0]), o, out, again);
        if (!out.empty()) at = {out.back().points.back()};
        parts.erase(next);
    }
    for (auto& curve : out) polygon::rotate(curve.points, o.angle);
    if (o.rings > 0) out = with_rings(std::move(out), region, o, notes);
    if (o.above != nullptr && !out.empty()) {
        const Loops inner = o.rings > 0 ? polygon::inset(*o.above, o.rings * w) : Loops{}; // within its rings
        again += lead_back(out.back(), inner.size() > 0 ? inner : *o.above, w);
    }
    if (again > 0) {
        const Vec2 p = out.front().points.front();
        notes.push_back({NoteCode::path_runs_twice, again, 1, -1, p.x, p.y});
    }
    polygon::note_unplaced(region, polygon::inset(first, -w / 2), w, notes);
    return out;
}

} // namespace filum::fill::scaffold
