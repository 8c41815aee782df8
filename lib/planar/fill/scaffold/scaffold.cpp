#include "fill/scaffold/scaffold.hpp"

#include "fill/join/cycle.hpp"
#include "fill/join/double_spiral.hpp"
#include "fill/scaffold/strand_bead.hpp"
#include "geom/segment.hpp"
#include "polygon/clip.hpp"
#include "polygon/inset.hpp"
#include "polygon/stretches.hpp"
#include "rings/lanes.hpp"
#include "toolpath/curve_place.hpp"
#include "toolpath/merge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::fill::scaffold {

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

// Adds the curves of one connected part: its strands and the turns between them.
void fill_with_strands(const Loops& part, const Loops& frame, std::optional<Vec2> from, const ScaffoldOptions& o,
                       std::vector<toolpath::Curve>& out, double& again) {
    const double w = o.bead_width;
    StrandGraph graph = strand_graph(part, heights(part, frame, o), w, from);
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

// Lets the curve begin at `from`, within the part, if its start is more than a bead away and no bead lies between. The
// part grows there from layer to layer.
void begin_at(toolpath::Curve& curve, Vec2 from, const Loops& part, double width) {
    const Vec2 start = curve.points.front();
    if (geom::distance(from, start) <= width || !polygon::contains(part, from)) return;
    const Vec2 near =
        geom::lerp(start, from, kLeastMove / geom::distance(from, start)); // the start itself is no obstacle
    const auto own = segments({curve});
    if (std::any_of(own.begin(), own.end(), [&](const auto& s) { return geom::cross_properly(from, near, s.a, s.b); }))
        return;
    curve.points.insert(curve.points.begin(), from);
    if (curve.width.size() > 1) curve.width.insert(curve.width.begin(), curve.width.front());
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
        const bool lifted = out.empty() && o.from;
        fill_with_strands(*next, turned, at.empty() ? std::nullopt : std::optional(at[0]), o, out, again);
        if (lifted && !out.empty()) begin_at(out.front(), at[0], *next, w);
        if (!out.empty()) at = {out.back().points.back()};
        parts.erase(next);
    }
    for (auto& curve : out) polygon::rotate(curve.points, o.angle);
    if (o.rings > 0) out = with_rings(std::move(out), region, o, notes);
    if (again > 0) {
        const Vec2 p = out.front().points.front();
        notes.push_back({NoteCode::path_runs_twice, again, 1, -1, p.x, p.y});
    }
    polygon::note_unplaced(region, polygon::inset(first, -w / 2), w, notes);
    return out;
}

} // namespace filum::fill::scaffold
