#include "fill/spacing.hpp"

#include "fill/none.hpp"
#include "fill/ring_samples.hpp"
#include "polygon/segments.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace filum::fill {

namespace {

using geom::Segment;
using geom::SegmentGrid;

constexpr double kSliver = 0.12;   // bead widths: rings nearer to the medial axis all along are left out
constexpr double kBlind = 0.3;     // bead widths of arc length about a sample that say nothing of the wall
constexpr double kAcross = 2.4;    // bead widths: the far side of a wall without a ring between is nearer
constexpr double kOpposite = -0.5; // cosine between the inner normals of two sides of a wall, at most

// What the middle of the wall asks of a sample.
struct Share {
    double error = 0;   // e: what is missing (or too much, if negative) up to the medial axis, mm
    int rank = 0;       // 0 next to the axis, 1 the ring outside it ...
    int lanes = 0;      // rings that share the error; 0: none asked
    double thinner = 0; // than the width, mm: the bead in a thin wall
    [[nodiscard]] double move() const { return lanes == 0 ? 0 : (1 - (2.0 * rank + 1) / (2.0 * lanes)) * error; }
    [[nodiscard]] double widen() const { return lanes == 0 ? 0 : error / lanes - thinner; }
};

class Spacing {
  public:
    Spacing(const Rings& rings, const Loops& boundary, double width, int lanes)
        : samples_(rings, 0.75 * width, 1.5 * width), edges_(polygon::segments(boundary)),
          edge_grid_(edges_, 1.5 * width), width_(width), lanes_(lanes) {}

    // Rings that keep so close to the medial axis that the ring around them does better alone.
    [[nodiscard]] std::vector<char> slivers() const {
        const Loops& loops = samples_.rings().loops;
        std::vector<char> out(loops.size(), 0);
        for (std::uint32_t r = 0; r < loops.size(); ++r) {
            if (samples_.rings().level[r] == 0) continue;
            bool sliver = true;
            for (std::uint32_t i = loops.start[r]; i < loops.start[r + 1] && sliver; ++i) {
                const Normal n = samples_.normal(i);
                const auto hit = samples_.hit(i, n.inward, kAcross * width_);
                sliver = n.mitre == 0 || n.mitre > 1.5 || (hit && hit->distance < 2 * kSliver * width_);
            }
            out[r] = sliver ? 1 : 0;
        }
        return out;
    }

    BeadRings run(double tolerance) {
        share();
        smooth();
        undo_crossings();
        return simplified(tolerance);
    }

  private:
    // From the innermost level outwards, so that a ring can ask the one inside it.
    void share() {
        const Loops& loops = samples_.rings().loops;
        shares_.resize(samples_.size());
        known_.assign(samples_.size(), 1);
        outside_.resize(samples_.size());
        room_.resize(samples_.size());
        std::vector<std::uint32_t> order(loops.size());
        std::iota(order.begin(), order.end(), 0U);
        std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return samples_.rings().level[a] > samples_.rings().level[b];
        });
        for (const std::uint32_t r : order)
            for (std::uint32_t i = loops.start[r]; i < loops.start[r + 1]; ++i) shares_[i] = ask(i);
    }

    Share ask(std::uint32_t i) {
        known_[i] = 0;
        const Normal n = samples_.normal(i);
        measure_outside(i, n);
        if (n.mitre == 0 || n.mitre > 1.5) return {}; // a sharp corner faces nothing in particular
        const auto hit = samples_.hit(i, n.inward, kAcross * width_);
        if (!hit) return end_of_wall(i);
        if (samples_.level(hit->segment) > samples_.level(i)) return known_[i] = 1, of_child(*hit);
        const Normal there = samples_.side(hit->segment);
        if (geom::dot(n.inward, there.inward) > kOpposite) return end_of_wall(i);
        const double half_gap = std::min(hit->distance / 2, 1.1 * width_);
        if (samples_.inner_radius(i, n.inward, half_gap, kBlind * width_) < 0.8 * half_gap) return end_of_wall(i);
        known_[i] = 1;
        if (thin(i)) return {0, 0, 1, width_ - outside_[i] - half_gap};
        const int lanes = std::min(lanes_, samples_.level(i) + 1);
        return {half_gap - outside_[i], 0, lanes, 0};
    }

    // A sample that faces no other side: a ring inside another keeps its distance from that one there; what to do on
    // level 0, the neighbours know.
    Share end_of_wall(std::uint32_t i) {
        known_[i] = samples_.level(i) > 0 ? 1 : 0;
        return {};
    }

    // How far outwards the space of a bead on level 0 goes: half a width, or to the outline where that is nearer.
    void measure_outside(std::uint32_t i, const Normal& n) {
        outside_[i] = room_[i] = width_ / 2;
        if (samples_.level(i) > 0) return;
        room_[i] = 0; // where the ray slips past the outline, at a tip, nothing may move outwards
        if (n.mitre == 0) return;
        const auto edge = first_hit(edge_grid_, edges_, samples_.point(i), -1.0 * n.inward, width_, kNone, kNone);
        if (edge) outside_[i] = room_[i] = std::min(width_ / 2, edge->distance / n.mitre);
    }
    // Placed in the middle of its half of a thin wall already.
    [[nodiscard]] bool thin(std::uint32_t i) const { return outside_[i] < 0.47 * width_; }

    // One rank farther out than the ring inside, at the place that the normal hits.
    [[nodiscard]] Share of_child(const Hit& hit) const {
        const Share &a = shares_[hit.segment], &b = shares_[samples_.next(hit.segment)];
        if (a.lanes == 0 || b.lanes == 0 || a.rank != b.rank || a.rank + 1 >= a.lanes) return {};
        return {(1 - hit.along) * a.error + hit.along * b.error, a.rank + 1, a.lanes, 0};
    }

    void smooth() {
        const std::uint32_t n = samples_.size();
        move_.resize(n), widen_.resize(n);
        for (std::uint32_t i = 0; i < n; ++i) move_[i] = shares_[i].move(), widen_[i] = shares_[i].widen();
        fill_unknown();
        std::vector<double> m(n), v(n);
        for (int pass = 0; pass < 3; ++pass) {
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t a = samples_.before(i), b = samples_.next(i);
                m[i] = 0.25 * (move_[a] + 2 * move_[i] + move_[b]);
                v[i] = 0.25 * (widen_[a] + 2 * widen_[i] + widen_[b]);
            }
            move_.swap(m), widen_.swap(v);
        }
        for (std::uint32_t i = 0; i < n; ++i) move_[i] = std::clamp(move_[i], -0.6 * room_[i], 0.5 * width_);
    }

    // Corners and ends take the mean of the nearest samples along the ring that know, if those are near enough.
    void fill_unknown() {
        constexpr int kFar = 6; // samples
        for (std::uint32_t i = 0; i < samples_.size(); ++i) {
            if (known_[i]) continue;
            std::uint32_t a = samples_.before(i), b = samples_.next(i);
            for (int k = 1; k < kFar && !known_[a]; ++k) a = samples_.before(a);
            for (int k = 1; k < kFar && !known_[b]; ++k) b = samples_.next(b);
            const double own = 2 * outside_[i] - width_;
            const double va = known_[a] ? widen_[a] : own, vb = known_[b] ? widen_[b] : own;
            move_[i] = ((known_[a] ? move_[a] : 0) + (known_[b] ? move_[b] : 0)) / 2;
            widen_[i] = (va + vb) / 2;
        }
    }

    [[nodiscard]] Vec2 moved(std::uint32_t i) const {
        if (move_[i] == 0) return samples_.point(i);
        const Normal n = samples_.normal(i);
        return samples_.point(i) + (move_[i] * n.mitre) * n.inward;
    }

    void undo_crossings() {
        const std::uint32_t n = samples_.size();
        result_.resize(n);
        for (int round = 0; round < 8; ++round) {
            for (std::uint32_t i = 0; i < n; ++i) result_[i] = moved(i);
            std::vector<Segment> now(n);
            for (std::uint32_t i = 0; i < n; ++i) now[i] = {result_[i], result_[samples_.next(i)]};
            const auto bad = crossing(now);
            if (bad.empty()) return;
            for (const std::uint32_t i : bad) still(i, 3 + 3 * round);
        }
        std::fill(move_.begin(), move_.end(), 0.0);
        result_ = samples_.rings().loops.points;
    }

    // Segments that cross another; only those with a moved end can.
    [[nodiscard]] std::vector<std::uint32_t> crossing(const std::vector<Segment>& now) const {
        const SegmentGrid grid(now, 1.5 * width_);
        std::vector<std::uint32_t> bad;
        for (std::uint32_t i = 0; i < now.size(); ++i) {
            if (move_[i] == 0 && move_[samples_.next(i)] == 0) continue;
            bool crosses = false;
            const Vec2 a = now[i].a, b = now[i].b;
            const Vec2 lo{std::min(a.x, b.x), std::min(a.y, b.y)}, hi{std::max(a.x, b.x), std::max(a.y, b.y)};
            grid.near(lo, hi, [&](std::uint32_t j) {
                if (j != i && geom::cross_properly(a, b, now[j].a, now[j].b)) crosses = true, bad.push_back(j);
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
            a = samples_.before(a), b = samples_.next(b);
            move_[a] = move_[b] = 0;
        }
    }

    // Drops the points that the straight line and the evenly changing width between their neighbours tell as well.
    [[nodiscard]] BeadRings simplified(double tolerance) const {
        const Loops& loops = samples_.rings().loops;
        BeadRings out;
        for (std::uint32_t r = 0; r < loops.size(); ++r) {
            const std::uint32_t first = loops.start[r], last = loops.start[r + 1];
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
        // machines lay a segment in one width: it must not differ much between the ends
        if (std::abs(widen_[a] - widen_[b]) > 0.08 * width_) return false;
        const Vec2 p = result_[a], q = result_[b];
        for (std::uint32_t i = a + 1; i < b; ++i) {
            const double t = geom::nearest_parameter(p, q, result_[i]);
            if (geom::distance(geom::lerp(p, q, t), result_[i]) > tolerance) return false;
            if (std::abs(widen_[a] + t * (widen_[b] - widen_[a]) - widen_[i]) > 0.02 * width_) return false;
        }
        return true;
    }

    RingSamples samples_;
    std::vector<Segment> edges_;
    SegmentGrid edge_grid_;
    double width_;
    int lanes_;
    std::vector<Share> shares_;
    std::vector<char> known_;
    std::vector<double> outside_, room_; // per sample, mm: to the edge of its bead's space; how far it may move out
    std::vector<double> move_, widen_;   // per sample, mm: inwards; added to the width
    std::vector<Vec2> result_;
};

Rings without(const Rings& rings, const std::vector<char>& left_out) {
    Rings out;
    for (std::size_t r = 0; r < rings.loops.size(); ++r) {
        if (left_out[r]) continue;
        out.loops.add(rings.loops[r]);
        out.level.push_back(rings.level[r]);
    }
    return out;
}

} // namespace

BeadRings even_spacing(const Rings& rings, const Loops& boundary, double width, int lanes, double tolerance) {
    if (lanes == 0) return {rings.loops, std::vector<double>(rings.loops.points.size(), width)};
    Spacing all(rings, boundary, width, lanes);
    const auto slivers = all.slivers();
    if (std::find(slivers.begin(), slivers.end(), 1) == slivers.end()) return all.run(tolerance);
    return Spacing(without(rings, slivers), boundary, width, lanes).run(tolerance);
}

} // namespace filum::fill
