#include "fill/cycle.hpp"

#include "fill/links.hpp"
#include "fill/ring_graph.hpp"
#include "polygon/segments.hpp"

#include <algorithm>
#include <numeric>

namespace filum::fill {

namespace {

constexpr double kReach = 2.2;       // bead widths: neighbours are nearer (Lemma 2: at most 2)
constexpr double kLongestLink = 2.4; // bead widths
constexpr double kSpeck = 0.0125;    // bead widths: shorter segments could cross their neighbours once rounded

// Two rings facing each other at one place.
struct Candidate {
    std::uint32_t ring, other;
    double s;    // on `ring`
    Vec2 across; // unit, towards the other ring
    double bead; // mm, the narrower bead of the two
    double score;
};

// One exchange: both rings lose their window, two links join the four ends.
struct Bridge {
    std::uint32_t ring[2];
    double s0[2], s1[2];   // windows, s1 > s0
    Vec2 begin[2], end[2]; // the points at s0 and s1
    bool parallel;         // links run begin-begin and end-end, else begin-end
    [[nodiscard]] geom::Segment link(int k) const {
        if (parallel) return k == 0 ? geom::Segment{begin[0], begin[1]} : geom::Segment{end[0], end[1]};
        return k == 0 ? geom::Segment{begin[0], end[1]} : geom::Segment{end[0], begin[1]};
    }
};

class Forest { // disjoint sets of rings
  public:
    explicit Forest(std::size_t n) : up_(n), groups_(n) { std::iota(up_.begin(), up_.end(), 0U); }
    std::uint32_t root(std::uint32_t i) {
        while (up_[i] != i) i = up_[i] = up_[up_[i]];
        return i;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = root(a), b = root(b);
        if (a != b) up_[std::max(a, b)] = std::min(a, b), --groups_;
    }
    [[nodiscard]] std::size_t groups() const { return groups_; }

  private:
    std::vector<std::uint32_t> up_;
    std::size_t groups_;
};

// The windows in use on each ring.
class Windows {
  public:
    explicit Windows(const RingGraph& graph) : graph_(&graph), used_(graph.size()) {}
    [[nodiscard]] bool free(std::uint32_t ring, double s0, double s1) const {
        const double l = graph_->length(ring);
        if (s1 - s0 > 0.6 * l) return false;
        for (const auto& [a, b] : used_[ring])
            for (const double shift : {-l, 0.0, l})
                if (s0 + shift < b && a < s1 + shift) return false;
        return true;
    }
    void take(std::uint32_t ring, double s0, double s1) { used_[ring].emplace_back(s0, s1); }

  private:
    const RingGraph* graph_;
    std::vector<std::vector<std::pair<double, double>>> used_;
};

// The line without segments shorter than `least`, but never with fewer than three points.
ClosedLine without_specks(const ClosedLine& line, double least) {
    ClosedLine out;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        if (!out.points.empty() && geom::distance(out.points.back(), line.points[i]) < least) continue;
        out.points.push_back(line.points[i]);
        out.width.push_back(line.width[i]);
    }
    while (out.points.size() > 1 && geom::distance(out.points.front(), out.points.back()) < least)
        out.points.pop_back(), out.width.pop_back();
    return out.points.size() < 3 ? line : out;
}

class Joiner {
  public:
    Joiner(const BeadRings& rings, double width, const Loops& outline)
        : graph_(rings, 1.5 * width), outline_(polygon::segments(outline)), outline_grid_(outline_, 1.5 * width),
          width_(width), forest_(graph_.size()), windows_(graph_), links_(1.5 * width) {}

    std::vector<ClosedLine> run() {
        // few samples first: most rings face their neighbours all the way round
        for (const double samples : {8.0, 64.0, 1024.0}) {
            if (forest_.groups() <= 1) break;
            const auto found = candidates(samples);
            for (const double half : {0.5, 0.3, 0.17}) accept(found, half);
        }
        if (forest_.groups() > 1) { // parts that only touch: links beside a neck of no width leave the region a little
            stay_inside_ = false;
            const auto found = candidates(1024);
            for (const double half : {0.3, 0.17, 0.05}) accept(found, half);
        }
        return trace();
    }

  private:
    // Places, evenly spread over every ring that still stands apart, where another ring is near.
    std::vector<Candidate> candidates(double samples) {
        std::vector<Candidate> out;
        const std::uint32_t largest = largest_group();
        for (std::uint32_t r = 0; r < graph_.size(); ++r) {
            if (forest_.root(r) == largest && samples > 8) continue;
            const double l = graph_.length(r);
            const auto n = static_cast<int>(std::clamp(l / (0.25 * width_), 1.0, samples));
            for (int k = 0; k < n; ++k) {
                const double s = l * (k + 0.5) / n;
                const Vec2 here = graph_.at(r, s);
                const auto there = graph_.nearest(
                    here, kReach * width_, [&](std::uint32_t other) { return forest_.root(other) != forest_.root(r); });
                if (!there || there->distance == 0) continue;
                const double gap = there->distance / width_;
                const double turn = graph_.turning(r, s - 0.6 * width_, s + 0.6 * width_) +
                                    graph_.turning(there->ring, there->s - 0.6 * width_, there->s + 0.6 * width_);
                const Vec2 across = (1 / there->distance) * (there->point - here);
                const double bead = std::min(graph_.width(r, s), graph_.width(there->ring, there->s));
                out.push_back({r, there->ring, s, across, std::min(bead, width_),
                               std::abs(gap - 1) + 0.5 * turn + (gap > 1.3 ? 3 : 0)});
            }
        }
        std::stable_sort(out.begin(), out.end(),
                         [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
        return out;
    }

    std::uint32_t largest_group() {
        std::vector<std::uint32_t> count(graph_.size(), 0);
        for (std::uint32_t r = 0; r < graph_.size(); ++r) ++count[forest_.root(r)];
        return static_cast<std::uint32_t>(std::max_element(count.begin(), count.end()) - count.begin());
    }

    void accept(const std::vector<Candidate>& found, double half) {
        for (const Candidate& c : found) {
            if (forest_.groups() <= 1) return;
            if (forest_.root(c.ring) == forest_.root(c.other)) continue;
            Bridge b;
            const double window = half * c.bead; // the links are beads, too, and as wide as those they join
            if (!make(c, window, b) || !fits(b, window)) continue;
            for (const int k : {0, 1}) windows_.take(b.ring[k], b.s0[k], b.s1[k]);
            for (const int k : {0, 1}) links_.push_back(b.link(k));
            bridges_.push_back(b);
            forest_.unite(c.ring, c.other);
        }
    }

    // The window of `half` on each side of the candidate's place, and the one straight across on the other ring, so
    // that the two links run side by side like beads.
    bool make(const Candidate& c, double half, Bridge& b) const {
        const double s0 = c.s - half, s1 = c.s + half;
        if (2 * half > 0.45 * graph_.length(c.ring)) return false;
        const Vec2 a0 = graph_.at(c.ring, s0), a1 = graph_.at(c.ring, s1);
        const auto p = graph_.hit(a0, c.across, c.other, kLongestLink * width_);
        const auto q = graph_.hit(a1, c.across, c.other, kLongestLink * width_);
        if (!p || !q) return false;
        const double l = graph_.length(c.other);
        double ahead = std::fmod(q->s - p->s, l); // from p forward to q
        if (ahead < 0) ahead += l;
        b.parallel = ahead < l / 2;
        const double gone = b.parallel ? ahead : l - ahead;
        if (gone < 0.4 * half || gone > 6 * half || gone > 0.45 * l) return false;
        const double t0 = b.parallel ? p->s : q->s;
        b.ring[0] = c.ring, b.ring[1] = c.other;
        b.s0[0] = s0, b.s1[0] = s1, b.s0[1] = t0, b.s1[1] = t0 + gone;
        for (const int k : {0, 1}) b.begin[k] = graph_.at(b.ring[k], b.s0[k]), b.end[k] = graph_.at(b.ring[k], b.s1[k]);
        return true;
    }

    [[nodiscard]] bool fits(const Bridge& b, double half) const {
        for (const int k : {0, 1})
            if (!windows_.free(b.ring[k], b.s0[k] - half / 2, b.s1[k] + half / 2)) return false;
        const geom::Segment u = b.link(0), v = b.link(1);
        if (geom::cross_properly(u.a, u.b, v.a, v.b)) return false;
        for (const auto& l : {u, v}) {
            if (geom::distance(l.a, l.b) > kLongestLink * width_) return false;
            // not quite to the ends, which lie on rings
            if (graph_.crosses(geom::lerp(l.a, l.b, 0.02), geom::lerp(l.a, l.b, 0.98))) return false;
            if (stay_inside_ && outline_grid_.crosses(l.a, l.b, outline_, [](std::uint32_t) { return true; }))
                return false;
            if (links_.any_nearer(l, 0.1 * width_)) return false;
        }
        return true;
    }

    struct End {
        std::uint32_t arc;
        bool last; // the arc's last point, else its first
    };
    struct Arc {
        std::uint32_t ring;
        double s0, s1;
        End next[2]; // what the links at its first and last point lead to
    };

    std::vector<Arc> cut() const {
        // per ring the cuts in order of arc length; an arc runs from each cut to the next
        struct Cut {
            double s0, s1;
            std::uint32_t bridge;
            int side;
        };
        std::vector<std::vector<Cut>> cuts(graph_.size());
        for (std::uint32_t k = 0; k < bridges_.size(); ++k)
            for (const int side : {0, 1}) {
                const Bridge& b = bridges_[k];
                const double l = graph_.length(b.ring[side]), shift = std::floor(b.s0[side] / l) * l;
                cuts[b.ring[side]].push_back({b.s0[side] - shift, b.s1[side] - shift, k, side});
            }
        std::vector<Arc> arcs;
        std::vector<End> at_begin(2 * bridges_.size()), at_end(2 * bridges_.size()); // per window: its two rims
        for (std::uint32_t r = 0; r < graph_.size(); ++r) {
            auto& c = cuts[r];
            std::sort(c.begin(), c.end(), [](const Cut& a, const Cut& b) { return a.s0 < b.s0; });
            const auto first = static_cast<std::uint32_t>(arcs.size()), n = static_cast<std::uint32_t>(c.size());
            for (std::uint32_t k = 0; k < n; ++k) {
                const bool wraps = k + 1 == n;
                const Cut& here = c[k];
                arcs.push_back({r, here.s1, c[wraps ? 0 : k + 1].s0 + (wraps ? graph_.length(r) : 0), {}});
                at_end[2 * here.bridge + static_cast<std::uint32_t>(here.side)] = {first + k, false};
                at_begin[2 * here.bridge + static_cast<std::uint32_t>(here.side)] = {first + (k + n - 1) % n, true};
            }
            if (n == 0) arcs.push_back({r, 0, graph_.length(r), {{first, true}, {first, false}}});
        }
        const auto tie = [&](End a, End b) {
            arcs[a.arc].next[a.last ? 1 : 0] = b;
            arcs[b.arc].next[b.last ? 1 : 0] = a;
        };
        for (std::uint32_t k = 0; k < bridges_.size(); ++k) {
            tie(at_begin[2 * k], bridges_[k].parallel ? at_begin[2 * k + 1] : at_end[2 * k + 1]);
            tie(at_end[2 * k], bridges_[k].parallel ? at_end[2 * k + 1] : at_begin[2 * k + 1]);
        }
        return arcs;
    }

    [[nodiscard]] std::vector<ClosedLine> trace() const {
        const auto arcs = cut();
        std::vector<char> seen(arcs.size(), 0);
        std::vector<ClosedLine> out;
        ClosedLine piece;
        for (std::uint32_t start = 0; start < arcs.size(); ++start) {
            if (seen[start]) continue;
            ClosedLine line;
            End at{start, false}; // where the next arc is entered
            while (!seen[at.arc]) {
                const Arc& arc = arcs[at.arc];
                seen[at.arc] = 1;
                piece.points.clear(), piece.width.clear();
                graph_.append(arc.ring, arc.s0, arc.s1, piece.points, piece.width);
                if (at.last) {
                    std::reverse(piece.points.begin(), piece.points.end());
                    std::reverse(piece.width.begin(), piece.width.end());
                }
                line.points.insert(line.points.end(), piece.points.begin(), piece.points.end());
                line.width.insert(line.width.end(), piece.width.begin(), piece.width.end());
                at = arc.next[at.last ? 0 : 1];
            }
            out.push_back(without_specks(line, kSpeck * width_));
        }
        std::stable_sort(out.begin(), out.end(), [](const ClosedLine& a, const ClosedLine& b) {
            return polygon::perimeter(a.points) > polygon::perimeter(b.points);
        });
        return out;
    }

    RingGraph graph_;
    std::vector<geom::Segment> outline_;
    geom::SegmentGrid outline_grid_;
    double width_;
    bool stay_inside_ = true;
    Forest forest_;
    Windows windows_;
    std::vector<Bridge> bridges_;
    Links links_;
};

} // namespace

std::vector<ClosedLine> join_rings(const BeadRings& rings, double width, const Loops& outline) {
    if (rings.loops.empty()) return {};
    return Joiner(rings, width, outline).run();
}

} // namespace filum::fill
