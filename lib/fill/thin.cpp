#include "fill/thin.hpp"

#include "fill/medial_axis.hpp"
#include "geom/segment_grid.hpp"
#include "polygon/clip.hpp"
#include "polygon/segments.hpp"

#include <algorithm>
#include <numbers>
#include <queue>

namespace filum::fill {

namespace {

constexpr double kTipReach = 0.4;  // bead widths: shorter tips are not followed
constexpr double kThinWall = 0.55; // bead widths: walls of a smaller half-thickness are thin; above a half, so that the
                                   // rings of thin and fat parts overlap well where they meet
constexpr double kFat = 0.95;      // bead widths: from here on a depth of half a bead is as good
constexpr double kLaneOffset =
    0.03; // bead widths: half of what the lanes in a thin wall keep between them, so as not to touch
constexpr double kHairline = 0.015; // bead widths: tips of a smaller half-thickness have no room for two lanes, which
                                    // would leave the area there and meet those of a neighbour

// mm: how far from the medial axis the lanes of a thin wall run where its half-thickness is r.  Where a neck leaves no
// room, they lie in the parts that it joins.
double lane(double r, double width) {
    if (r < kHairline * width * (1 - 1e-9)) return kLaneOffset * width;
    return std::max(r / 2, std::min(kLaneOffset * width, r - kHairline / 3 * width));
}

int outer_loops(const Loops& a) {
    int n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) n += polygon::signed_area(a[i]) > 0 ? 1 : 0;
    return n;
}

// Whether some corner of the area lies farther than `far` from every ring: what sticks out farthest is a corner.
bool reaches_beyond(const Loops& area, const Loops& rings, double far) {
    const auto segments = polygon::segments(rings);
    const geom::SegmentGrid grid(segments, far);
    return std::any_of(area.points.begin(), area.points.end(), [&](Vec2 p) {
        bool near = false;
        grid.near({p.x - far, p.y - far}, {p.x + far, p.y + far}, [&](std::uint32_t i) {
            near = near || geom::point_segment_distance(segments[i].a, segments[i].b, p) <= far;
        });
        return !near;
    });
}

// Area of what beads of half-width r along `rings` cover, rings included: the Steiner formula, with sectors at convex
// corners and none of the overlap at reflex ones.
double swept_area(const Loops& rings, double r) {
    double area = polygon::signed_area(rings);
    for (std::size_t l = 0; l < rings.size(); ++l) {
        const auto loop = rings[l];
        area += polygon::perimeter(loop) * r;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 u = loop[i] - loop[i == 0 ? loop.size() - 1 : i - 1], v = loop[(i + 1) % loop.size()] - loop[i];
            const double turn = std::atan2(geom::cross(u, v), geom::dot(u, v));
            area += r * r * (turn > 0 ? turn / 2 : std::tan(turn / 2));
        }
    }
    return area;
}

// Area of the thin wall along an edge of the medial axis between two straight sides.
double wall_area(const MedialAxis& axis, const std::vector<std::uint32_t>& edges) {
    double area = 0;
    for (const auto k : edges) {
        const double ra = axis.radius[axis.a[k]], rb = axis.radius[axis.b[k]];
        const double l = geom::distance(axis.point[axis.a[k]], axis.point[axis.b[k]]);
        area += (ra + rb) * std::sqrt(std::max(0.0, l * l - (ra - rb) * (ra - rb)));
    }
    return area;
}

// The edges of the medial axis that a thin wall's bead follows: radius below width/2 at one end at least, dead ends
// shortened until what they reach beyond the disc at their foot is worth following.
class ThinAxis {
  public:
    ThinAxis(const MedialAxis& axis, double width) : axis_(axis), width_(width) {
        const std::size_t n = axis.point.size();
        degree_.assign(n, 0), reach_.resize(n), at_.resize(n);
        for (std::uint32_t k = 0; k < axis.a.size(); ++k) {
            if (std::min(axis.radius[axis.a[k]], axis.radius[axis.b[k]]) >= kThinWall * width) continue;
            alive_.push_back(k);
            for (const auto v : {axis.a[k], axis.b[k]}) ++degree_[v], at_[v].push_back(k);
        }
        kept_.assign(axis.a.size(), 0);
        for (const auto k : alive_) kept_[k] = 1;
        for (std::size_t v = 0; v < n; ++v) reach_[v] = axis.radius[v];
        // 1e-9: where the axis was split the radius is off by rounding; what is a hairline all over is kept
        hairline_ = kHairline * width * (1 + 1e-9);
        if (*std::max_element(axis.radius.begin(), axis.radius.end()) <= hairline_) hairline_ = 0;
    }

    // Indices of the edges kept, ascending.
    std::vector<std::uint32_t> edges() {
        prune();
        ease_in();
        std::vector<std::uint32_t> out;
        for (std::uint32_t k = 0; k < kept_.size(); ++k)
            if (kept_[k]) out.push_back(k);
        return out;
    }

  private:
    void prune() {
        // leaves with the least reach first, so that the longer of two twigs survives; ties by vertex
        using Entry = std::pair<double, std::uint32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> leaves;
        for (std::uint32_t v = 0; v < degree_.size(); ++v)
            if (leaf(v)) leaves.emplace(reach_[v], v);
        while (!leaves.empty()) {
            const std::uint32_t v = leaves.top().second;
            leaves.pop();
            if (!leaf(v)) continue;
            const std::uint32_t k = *std::find_if(at_[v].begin(), at_[v].end(), [&](auto e) { return kept_[e] != 0; });
            const std::uint32_t u = axis_.a[k] == v ? axis_.b[k] : axis_.a[k];
            const double beyond = reach_[v] + geom::distance(axis_.point[u], axis_.point[v]);
            if (beyond - axis_.radius[u] > kTipReach * width_ && axis_.radius[u] > hairline_) continue;
            kept_[k] = 0;
            --degree_[u], --degree_[v];
            reach_[u] = std::max(reach_[u], beyond);
            if (leaf(u)) leaves.emplace(reach_[u], u);
        }
    }
    // From where thin walls end on into the fat part, as long as the wall gets thicker: there half the thickness and
    // half a bead's depth come to the same, and the ring has no notch.
    void ease_in() {
        std::vector<std::vector<std::uint32_t>> rising(axis_.point.size()); // per vertex: edges to thicker places
        for (std::uint32_t k = 0; k < axis_.a.size(); ++k) {
            const auto a = axis_.a[k], b = axis_.b[k];
            const double low = std::min(axis_.radius[a], axis_.radius[b]),
                         high = std::max(axis_.radius[a], axis_.radius[b]);
            if (low >= kThinWall * width_ && high <= kFat * width_)
                rising[axis_.radius[a] <= axis_.radius[b] ? a : b].push_back(k);
        }
        std::vector<std::uint32_t> pending;
        for (const auto k : alive_)
            if (kept_[k]) pending.push_back(axis_.a[k]), pending.push_back(axis_.b[k]);
        while (!pending.empty()) {
            const std::uint32_t v = pending.back();
            pending.pop_back();
            for (const auto k : rising[v]) {
                if (kept_[k]) continue;
                kept_[k] = 1;
                pending.push_back(axis_.a[k] == v ? axis_.b[k] : axis_.a[k]);
            }
        }
    }
    // A dead end that does not lie in a fat part.
    [[nodiscard]] bool leaf(std::uint32_t v) const { return degree_[v] == 1 && axis_.radius[v] < kThinWall * width_; }

    const MedialAxis& axis_;
    double width_;
    double hairline_ = 0; // mm
    std::vector<std::uint32_t> alive_;
    std::vector<int> degree_;
    std::vector<double> reach_; // per vertex: how far its discs and the twigs cut off there reach
    std::vector<std::vector<std::uint32_t>> at_;
    std::vector<char> kept_;
};

// The hull of two discs, counter-clockwise, as a polygon off by at most `tolerance` and never larger.
std::vector<Vec2> hull(Vec2 p, double rp, Vec2 q, double rq, double tolerance) {
    const double d = geom::distance(p, q);
    std::vector<Vec2> out;
    const auto arc = [&](Vec2 c, double r, double from, double to) {
        const double step = 2 * std::acos(std::clamp(1 - tolerance / std::max(r, tolerance), 0.0, 0.95));
        const int n = std::max(2, static_cast<int>(std::ceil((to - from) / step)));
        for (int k = 0; k <= n; ++k) {
            const double a = from + (to - from) * k / n;
            out.push_back(c + r * Vec2{std::cos(a), std::sin(a)});
        }
    };
    if (d <= std::abs(rp - rq) + 1e-9) {
        const bool first = rp >= rq;
        arc(first ? p : q, first ? rp : rq, 0, 2 * std::numbers::pi);
        out.pop_back();
        return out;
    }
    const double along = std::atan2(q.y - p.y, q.x - p.x), tilt = std::acos((rp - rq) / d);
    arc(p, rp, along + tilt, along + 2 * std::numbers::pi - tilt);
    arc(q, rq, along - tilt, along + tilt);
    return out;
}

// The union of `rings` and the hulls over edges, every disc about half as large as it can be.
Loops with_strips(Loops rings, const MedialAxis& axis, const std::vector<std::uint32_t>& edges, double width,
                  double tolerance) {
    for (const auto k : edges) {
        const auto a = axis.a[k], b = axis.b[k];
        rings.add(
            hull(axis.point[a], lane(axis.radius[a], width), axis.point[b], lane(axis.radius[b], width), tolerance));
    }
    return polygon::unite(rings);
}

// An area without a kept edge still gets a ring about its fattest point.
FirstRings round_fattest(const Loops& area, const MedialAxis& axis, double least, double tolerance) {
    const auto at =
        static_cast<std::size_t>(std::max_element(axis.radius.begin(), axis.radius.end()) - axis.radius.begin());
    const double full = axis.radius[at], r = std::max(least, full / 2);
    FirstRings out;
    out.rings.add(hull(axis.point[at], r, axis.point[at], r, tolerance));
    out.unplaced = std::max(0.0, polygon::signed_area(area) - std::numbers::pi * full * full);
    return out;
}

} // namespace

std::vector<std::uint32_t> thin_edges(const MedialAxis& axis, double width) { return ThinAxis(axis, width).edges(); }

FirstRings first_rings(const Loops& area, double width, double tolerance) {
    FirstRings out{polygon::simplify(polygon::offset(area, -width / 2, tolerance), tolerance), 0};
    out.unplaced = std::max(0.0, polygon::signed_area(area) - swept_area(out.rings, width / 2));
    const bool connected = outer_loops(out.rings) == outer_loops(area);
    if (connected && !reaches_beyond(area, out.rings, (0.5 + kTipReach) * width)) return out;

    const double least = kLaneOffset * width;
    MedialAxis axis = medial_axis(polygon::simplify(area, 2 * tolerance), width / 4);
    for (const double r : {kThinWall, kFat, kHairline}) axis = split_at(axis, r * width);
    if (axis.point.empty()) axis = medial_axis(area, width / 4); // a speck that simplifies to nothing
    if (axis.point.empty()) axis = {{area.points.front()}, {0}, {}, {}};
    const auto edges = thin_edges(axis, width);
    if (edges.empty()) return out.rings.empty() ? round_fattest(area, axis, least, tolerance) : out;
    out.rings = polygon::simplify(with_strips(std::move(out.rings), axis, edges, width, tolerance), tolerance);
    out.unplaced = std::max(0.0, out.unplaced - wall_area(axis, edges));
    return out;
}

} // namespace filum::fill
