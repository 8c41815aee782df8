#include "fill/spacing.hpp"

#include "geom/segment_grid.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace filum::fill {

namespace {

using geom::Segment;
using geom::SegmentGrid;

// Loops with points no farther apart than `step`.
Rings resampled(const Rings& in, double step) {
    Rings out;
    out.level = in.level;
    for (std::size_t r = 0; r < in.loops.size(); ++r) {
        const auto loop = in.loops[r];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 a = loop[i], b = loop[i + 1 == loop.size() ? 0 : i + 1];
            const int n = std::max(1, static_cast<int>(std::ceil(geom::distance(a, b) / step)));
            for (int k = 0; k < n; ++k) out.loops.points.push_back(geom::lerp(a, b, static_cast<double>(k) / n));
        }
        out.loops.close();
    }
    return out;
}

// The points of all loops with their neighbours, and the segment from each point to the next.
struct Samples {
    std::vector<std::uint32_t> ring, next, before;
    std::vector<Segment> segment;

    explicit Samples(const Loops& loops) {
        const std::size_t n = loops.points.size();
        ring.resize(n), next.resize(n), before.resize(n), segment.resize(n);
        for (std::uint32_t r = 0; r < loops.size(); ++r)
            for (std::uint32_t i = loops.start[r]; i < loops.start[r + 1]; ++i) {
                ring[i] = r;
                next[i] = i + 1 == loops.start[r + 1] ? loops.start[r] : i + 1;
                before[next[i]] = i;
                segment[i] = {loops.points[i], loops.points[next[i]]};
            }
    }
};

struct Normal {
    Vec2 inward;  // unit, to the left: into the solid
    double mitre; // how much farther a corner moves than its sides, at most 2
};

Normal normal_at(const Samples& s, std::uint32_t i) {
    const auto& u = s.segment[s.before[i]];
    const auto& v = s.segment[i];
    const Vec2 a = u.b - u.a, b = v.b - v.a;
    const double la = geom::norm(a), lb = geom::norm(b);
    if (la == 0 && lb == 0) return {{0, 0}, 0};
    const Vec2 na = la > 0 ? (1 / la) * geom::left_of(a) : (1 / lb) * geom::left_of(b);
    const Vec2 nb = lb > 0 ? (1 / lb) * geom::left_of(b) : na;
    const Vec2 sum = na + nb;
    const double l = geom::norm(sum);
    if (l < 1e-9) return {na, 1};
    return {(1 / l) * sum, std::min(2.0, 2 / l)};
}

struct Hit {
    std::uint32_t segment;
    double distance, along; // along: parameter on the segment
};

// The first segment hit from p in direction d (unit) within `reach`; `skip` names up to two segments not to look at.
std::optional<Hit> first_hit(const SegmentGrid& grid, const std::vector<Segment>& segments, Vec2 p, Vec2 d,
                             double reach, std::uint32_t skip_a, std::uint32_t skip_b) {
    std::optional<Hit> best;
    const Vec2 q = p + reach * d;
    grid.near({std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}, [&](std::uint32_t i) {
        if (i == skip_a || i == skip_b) return;
        const Segment& s = segments[i];
        const Vec2 e = s.b - s.a, f = s.a - p;
        const double det = geom::cross(d, e);
        if (det == 0) return;
        const double t = geom::cross(f, e) / det, u = geom::cross(f, d) / det;
        if (t <= 0 || t > reach || u < 0 || u > 1) return;
        if (!best || t < best->distance || (t == best->distance && i < best->segment)) best = Hit{i, t, u};
    });
    return best;
}

constexpr std::uint32_t kNone = 0xffffffff;

// What the middle of the wall asks of a sample.
struct Share {
    double error = 0; // e: what is missing (or too much, if negative) up to the medial axis, mm
    int rank = 0;     // 0 next to the axis, 1 the ring outside it ...
    int lanes = 0;    // rings that share the error; 0: none asked
    [[nodiscard]] double move() const { return lanes == 0 ? 0 : (1 - (2.0 * rank + 1) / (2.0 * lanes)) * error; }
    [[nodiscard]] double widen() const { return lanes == 0 ? 0 : error / lanes; }
};

class Spacing {
  public:
    Spacing(const Rings& rings, const Loops& boundary, double width, int lanes)
        : rings_(resampled(rings, 0.75 * width)), samples_(rings_.loops), grid_(samples_.segment, 1.5 * width),
          edges_(Samples(boundary).segment), edge_grid_(edges_, 1.5 * width), width_(width), lanes_(lanes) {}

    BeadRings run(double tolerance) {
        share();
        smooth();
        undo_crossings();
        return simplified(tolerance);
    }

  private:
    [[nodiscard]] int level(std::uint32_t sample) const { return rings_.level[samples_.ring[sample]]; }

    // From the innermost level outwards, so that a ring can ask the one inside it.
    void share() {
        const std::size_t n = rings_.loops.points.size();
        shares_.resize(n);
        std::vector<std::uint32_t> order(rings_.loops.size());
        for (std::uint32_t r = 0; r < order.size(); ++r) order[r] = r;
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return rings_.level[a] > rings_.level[b]; });
        for (const std::uint32_t r : order)
            for (std::uint32_t i = rings_.loops.start[r]; i < rings_.loops.start[r + 1]; ++i) shares_[i] = ask(i);
    }

    [[nodiscard]] Share ask(std::uint32_t i) const {
        const Normal n = normal_at(samples_, i);
        if (n.mitre == 0) return {};
        const Vec2 p = rings_.loops.points[i];
        const auto hit = first_hit(grid_, samples_.segment, p, n.inward, 2.3 * width_, i, samples_.before[i]);
        if (hit && level(hit->segment) > level(i)) return of_child(*hit);
        if (n.mitre > 1.5) return {}; // a sharp corner faces nothing in particular
        const double half_gap = std::min(hit ? hit->distance / 2 : width_, width_);
        const int lanes = std::min(lanes_, level(i) + 1);
        double outside = width_ / 2;
        if (level(i) == 0) {
            const auto edge = first_hit(edge_grid_, edges_, p, -1.0 * n.inward, 2 * width_, kNone, kNone);
            if (edge) outside = std::min(outside, edge->distance);
        }
        return {half_gap - outside, 0, lanes};
    }

    // One rank farther out than the ring inside, at the place that the normal hits.
    [[nodiscard]] Share of_child(const Hit& hit) const {
        const Share &a = shares_[hit.segment], &b = shares_[samples_.next[hit.segment]];
        if (a.lanes == 0 || b.lanes == 0 || a.rank != b.rank || a.rank + 1 >= a.lanes) return {};
        return {(1 - hit.along) * a.error + hit.along * b.error, a.rank + 1, a.lanes};
    }

    void smooth() {
        const std::size_t n = shares_.size();
        move_.resize(n), widen_.resize(n);
        for (std::size_t i = 0; i < n; ++i) move_[i] = shares_[i].move(), widen_[i] = shares_[i].widen();
        std::vector<double> m(n), v(n);
        for (int pass = 0; pass < 3; ++pass) {
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t a = samples_.before[i], b = samples_.next[i];
                m[i] = 0.25 * (move_[a] + 2 * move_[i] + move_[b]);
                v[i] = 0.25 * (widen_[a] + 2 * widen_[i] + widen_[b]);
            }
            move_.swap(m), widen_.swap(v);
        }
    }

    [[nodiscard]] Vec2 moved(std::uint32_t i) const {
        if (move_[i] == 0) return rings_.loops.points[i];
        const Normal n = normal_at(samples_, i);
        return rings_.loops.points[i] + (move_[i] * n.mitre) * n.inward;
    }

    void undo_crossings() {
        const std::size_t n = shares_.size();
        result_.resize(n);
        for (int round = 0; round < 8; ++round) {
            std::vector<Segment> now(n);
            for (std::uint32_t i = 0; i < n; ++i) result_[i] = moved(i);
            for (std::uint32_t i = 0; i < n; ++i) now[i] = {result_[i], result_[samples_.next[i]]};
            const auto bad = crossing(now);
            if (bad.empty()) return;
            for (const std::uint32_t i : bad) still(i, 3 + 3 * round);
        }
        std::fill(move_.begin(), move_.end(), 0.0);
        result_ = rings_.loops.points;
    }

    // Segments that cross another; only those with a moved end can.
    [[nodiscard]] std::vector<std::uint32_t> crossing(const std::vector<Segment>& now) const {
        const SegmentGrid grid(now, 1.5 * width_);
        std::vector<std::uint32_t> bad;
        for (std::uint32_t i = 0; i < now.size(); ++i) {
            if (move_[i] == 0 && move_[samples_.next[i]] == 0) continue;
            bool crosses = false;
            const Vec2 a = now[i].a, b = now[i].b;
            grid.near({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                      [&](std::uint32_t j) {
                          if (j != i && geom::cross_properly(a, b, now[j].a, now[j].b))
                              crosses = true, bad.push_back(j);
                      });
            if (crosses) bad.push_back(i);
        }
        return bad;
    }

    // Takes back the moves of sample i and its `reach` neighbours on either side.
    void still(std::uint32_t i, int reach) {
        std::uint32_t a = i, b = i;
        move_[i] = 0;
        for (int k = 0; k < reach; ++k) {
            a = samples_.before[a], b = samples_.next[b];
            move_[a] = move_[b] = 0;
        }
    }

    // Drops the points that the straight line and the evenly changing width between their neighbours tell as well.
    [[nodiscard]] BeadRings simplified(double tolerance) const {
        BeadRings out;
        for (std::uint32_t r = 0; r < rings_.loops.size(); ++r) {
            const std::uint32_t first = rings_.loops.start[r], last = rings_.loops.start[r + 1];
            const std::size_t before = out.loops.points.size();
            std::uint32_t kept = first;
            keep(first, out);
            for (std::uint32_t i = first + 1; i < last; ++i)
                if (i + 1 == last || !straight(kept, i + 1, tolerance)) keep(i, out), kept = i;
            if (out.loops.points.size() - before < 3) { // a ring of two points is none
                out.loops.points.resize(before), out.width.resize(before);
                for (std::uint32_t i = first; i < last; ++i) keep(i, out);
            }
            out.loops.close();
        }
        return out;
    }

    void keep(std::uint32_t i, BeadRings& out) const {
        out.loops.points.push_back(result_[i]);
        out.width.push_back(std::max(0.05 * width_, width_ + widen_[i]));
    }

    // All samples strictly between a and b lie on their chord, in place and in width.
    [[nodiscard]] bool straight(std::uint32_t a, std::uint32_t b, double tolerance) const {
        if (b - a > 200) return false; // bounds the work on long straight rings
        const Vec2 p = result_[a], q = result_[b];
        for (std::uint32_t i = a + 1; i < b; ++i) {
            const double t = geom::nearest_parameter(p, q, result_[i]);
            if (geom::distance(geom::lerp(p, q, t), result_[i]) > tolerance) return false;
            if (std::abs(widen_[a] + t * (widen_[b] - widen_[a]) - widen_[i]) > 0.02 * width_) return false;
        }
        return true;
    }

    Rings rings_;
    Samples samples_;
    SegmentGrid grid_;
    std::vector<Segment> edges_;
    SegmentGrid edge_grid_;
    double width_;
    int lanes_;
    std::vector<Share> shares_;
    std::vector<double> move_, widen_; // per sample, mm: inwards; added to the width
    std::vector<Vec2> result_;
};

} // namespace

BeadRings even_spacing(const Rings& rings, const Loops& boundary, double width, int lanes, double tolerance) {
    return Spacing(rings, boundary, width, lanes).run(tolerance);
}

} // namespace filum::fill
