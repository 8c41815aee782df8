#include "fill/thin.hpp"

#include "fill/medial_axis.hpp"
#include "geom/segment_grid.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <numbers>
#include <queue>

namespace filum::fill {

namespace {

constexpr double kReach = 0.4; // bead widths: shorter tips are not followed
constexpr double kThin = 0.55; // bead widths: walls of a smaller half-thickness are thin; above a half, so that the
                               // rings of thin and fat parts overlap well where they meet

int outer_loops(const Loops& a) {
    int n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) n += polygon::signed_area(a[i]) > 0 ? 1 : 0;
    return n;
}

// Whether some point of `rest` lies farther than `far` from every ring.
bool reaches_beyond(const Loops& rest, const Loops& rings, double far) {
    std::vector<geom::Segment> segments;
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (std::size_t i = 0; i < rings[r].size(); ++i)
            segments.push_back({rings[r][i], rings[r][(i + 1) % rings[r].size()]});
    const geom::SegmentGrid grid(segments, far);
    return std::any_of(rest.points.begin(), rest.points.end(), [&](Vec2 p) {
        bool near = false;
        grid.near({p.x - far, p.y - far}, {p.x + far, p.y + far}, [&](std::uint32_t i) {
            near = near || geom::point_segment_distance(segments[i].a, segments[i].b, p) <= far;
        });
        return !near;
    });
}

// The edges of the medial axis that a thin wall's bead follows: radius below width/2 at one end at least, dead ends
// shortened until what they reach beyond the disc at their foot is worth following.
class ThinAxis {
  public:
    ThinAxis(const MedialAxis& axis, double width) : axis_(axis), width_(width) {
        const std::size_t n = axis.point.size();
        degree_.assign(n, 0), reach_.resize(n), at_.resize(n);
        for (std::uint32_t k = 0; k < axis.a.size(); ++k) {
            if (std::min(axis.radius[axis.a[k]], axis.radius[axis.b[k]]) >= kThin * width) continue;
            alive_.push_back(k);
            for (const auto v : {axis.a[k], axis.b[k]}) ++degree_[v], at_[v].push_back(k);
        }
        kept_.assign(axis.a.size(), 0);
        for (const auto k : alive_) kept_[k] = 1;
        for (std::size_t v = 0; v < n; ++v) reach_[v] = axis.radius[v];
    }

    // Indices of the edges kept, ascending.
    std::vector<std::uint32_t> edges() {
        prune();
        std::vector<std::uint32_t> out;
        for (const auto k : alive_)
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
            if (beyond - axis_.radius[u] > kReach * width_) continue;
            kept_[k] = 0;
            --degree_[u], --degree_[v];
            reach_[u] = std::max(reach_[u], beyond);
            if (leaf(u)) leaves.emplace(reach_[u], u);
        }
    }
    // A dead end that does not lie in a fat part.
    [[nodiscard]] bool leaf(std::uint32_t v) const { return degree_[v] == 1 && axis_.radius[v] < kThin * width_; }

    const MedialAxis& axis_;
    double width_;
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

// The union of the hulls over edges, every disc `share` times as large as it can be, but at least `least`.
Loops strips(const MedialAxis& axis, const std::vector<std::uint32_t>& edges, double share, double least,
             double tolerance) {
    Loops all;
    for (const auto k : edges) {
        const auto a = axis.a[k], b = axis.b[k];
        all.add(hull(axis.point[a], std::max(least, share * axis.radius[a]), axis.point[b],
                     std::max(least, share * axis.radius[b]), tolerance));
    }
    return polygon::unite(all);
}

// An area without a kept edge still gets a ring about its fattest point.
Loops round_fattest(const MedialAxis& axis, double share, double least, double tolerance) {
    const auto fattest = std::max_element(axis.radius.begin(), axis.radius.end()) - axis.radius.begin();
    const Vec2 p = axis.point[static_cast<std::size_t>(fattest)];
    const double r = std::max(least, share * axis.radius[static_cast<std::size_t>(fattest)]);
    Loops out;
    out.add(hull(p, r, p, r, tolerance));
    return out;
}

} // namespace

FirstRings first_rings(const Loops& area, double width, double tolerance) {
    FirstRings out{polygon::simplify(polygon::offset(area, -width / 2, tolerance), tolerance), 0};
    const Loops rest = polygon::subtract(area, polygon::offset(out.rings, width / 2, tolerance));
    const bool connected = outer_loops(out.rings) == outer_loops(area);
    out.unplaced = std::max(0.0, polygon::signed_area(rest));
    if (connected && !reaches_beyond(rest, out.rings, (0.5 + kReach) * width)) return out;

    const double least = 0.03 * width; // lanes must not touch
    const MedialAxis axis = split_at(medial_axis(polygon::simplify(area, tolerance), width / 4), kThin * width);
    if (axis.point.empty()) return out;
    const auto edges = ThinAxis(axis, width).edges();
    if (edges.empty()) {
        if (out.rings.empty()) {
            out.rings = round_fattest(axis, 0.5, least, tolerance);
            out.unplaced =
                std::max(0.0, polygon::signed_area(polygon::subtract(rest, round_fattest(axis, 1, 0, tolerance))));
        }
        return out;
    }
    const Loops thin = strips(axis, edges, 0.5, least, tolerance);
    out.rings = polygon::simplify(polygon::unite(out.rings, thin), tolerance);
    out.unplaced = std::max(0.0, polygon::signed_area(polygon::subtract(rest, strips(axis, edges, 1, 0, tolerance))));
    return out;
}

} // namespace filum::fill
