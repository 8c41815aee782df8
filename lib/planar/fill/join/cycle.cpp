#include "fill/join/cycle.hpp"

#include "fill/join/double_spiral.hpp"
#include "fill/join/ring_graph.hpp"
#include "polygon/segments.hpp"
#include "weave/join.hpp"

#include <algorithm>

namespace filum::fill::join {

namespace {

constexpr double kPlaces = 12; // places along a ring where neighbours are sought
// Half the width of a link, in widths of its beads. Beside the turn from a bead into two links there is a void, which
// grows with the square of that width.
constexpr double kLink = 0.25;
constexpr double kAlike = 3; // largest ratio of the lengths of two facing windows

// Two rings facing each other at one place.
struct Candidate {
    std::uint32_t a, b; // rings
    double s;           // on a
    Vec2 across;        // unit, towards b
    double bead;        // mm, the narrower bead of the two
    double faults;      // mm off the ideal place
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
    // The links are as wide as they are apart.
    [[nodiscard]] Splice splice(double width) const {
        Splice out{{{ring[0], s0[0], s1[0]}, {ring[1], s0[1], s1[1]}},
                   {{{0, false}, {1, !parallel}, {}}, {{0, true}, {1, parallel}, {}}}};
        for (const int k : {0, 1})
            for (const double t : {kLinkEnd, 1 - kLinkEnd})
                out.links[static_cast<std::size_t>(k)].bead.add(geom::lerp(link(k).a, link(k).b, t), width);
        return out;
    }
};

class Joiner {
  public:
    Joiner(const rings::Rings& rings, double width, const OutlineEdges& outline, const Hanging& hung)
        : graph_(rings, 1.5 * width), outline_(&outline), width_(width), splices_(graph_), groups_(splices_.groups()),
          hung_(&hung) {
        for (std::uint32_t r = 1; r < graph_.size(); ++r) // open lines never join each other
            if (graph_.open(r)) groups_.unite(r - 1, r);
        if (!hung) return;
        for (std::uint32_t r = 0; r < rings.size(); ++r)
            over_air_.push_back(std::any_of(rings.points.begin() + rings.start[r],
                                            rings.points.begin() + rings.start[r + 1],
                                            [&](Vec2 p) { return hung(p) > 0; })
                                    ? 1
                                    : 0);
    }

    std::vector<Curve> run(bool spirals) {
        if (spirals) wind();
        // few places first: most rings face their neighbours all the way round
        for (const bool all : {false, true}) {
            if (groups_.sets() <= 1) break;
            link(all, {kLink});
        }
        for (may_hang_ = 1; *hung_ && may_hang_ <= kHangsMost && groups_.sets() > 1; ++may_hang_) link(true, {kLink});
        if (groups_.sets() > 1 &&
            !graph_.open(0)) { // parts that only touch: links beside a neck of no width may leave the region
            stay_inside_ = false;
            link(true, {kLink, rings::kNarrowest});
        }
        return splices_.trace();
    }

  private:
    // Adds exchanges at a few places of each ring, or at all of them; for each width in `halves`, in order.
    void link(bool all, std::initializer_list<double> halves) {
        const auto found = candidates(all);
        for (const double half : halves)
            weave::join(groups_, found, [&](const Candidate& c) {
                Bridge b;
                const double window = half * c.bead;
                if (make(c, window, b) && fits(b, window)) splices_.add(b.splice(2 * window));
            });
    }

    // Adds double spirals wherever three or more rings that are still apart run side by side. Goes from the outside in,
    // so that most begin at an outline and end at a centre.
    void wind() {
        std::vector<char> wound(graph_.size(), 0);
        for (std::uint32_t r = 0; r < graph_.size() && groups_.sets() > 1; ++r) {
            if (wound[r] || runs_over_air(r)) continue;
            const auto splice = best_spiral(r);
            if (!splice) continue;
            for (const weave::Window& w : splice->windows) wound[w.curve] = 1;
            splices_.add(*splice);
        }
    }

    [[nodiscard]] bool runs_over_air(std::uint32_t ring) const { return !over_air_.empty() && over_air_[ring] != 0; }

    // The double spiral with the most lanes across ring r, among a few places.
    [[nodiscard]] std::optional<Splice> best_spiral(std::uint32_t r) {
        const double l = graph_.length(r);
        const auto n = static_cast<int>(std::clamp(l / (2 * width_), 1.0, kPlaces));
        std::vector<Lanes> found;
        for (int k = 0; k < n; ++k) {
            std::vector<std::uint32_t> roots{groups_.root(r)};
            found.push_back(lanes_across(graph_, r, l * (k + 0.5) / n, k % 2 == 0, width_, [&](std::uint32_t other) {
                const std::uint32_t root = groups_.root(other);
                if (runs_over_air(other) || std::find(roots.begin(), roots.end(), root) != roots.end()) return false;
                roots.push_back(root);
                return true;
            }));
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const Lanes& a, const Lanes& b) { return a.lane.size() > b.lane.size(); });
        const Room room{[&](std::uint32_t ring, double s0, double s1) { return splices_.free(ring, s0, s1); },
                        [&](Vec2 a, Vec2 b) {
                            return clear({a, b});
                        }};
        std::optional<Splice> best;
        for (std::size_t k = 0; k < found.size(); ++k) {
            if (best && best->windows.size() >= found[k].lane.size()) break;
            auto splice = double_spiral(graph_, found[k], width_, room);
            if (splice && (!best || splice->windows.size() > best->windows.size())) best = std::move(splice);
        }
        return best;
    }

    // True if no outline crosses this link.
    [[nodiscard]] bool clear(const geom::Segment& l) const {
        return !stay_inside_ || !outline_->grid.crosses(l.a, l.b, outline_->edge, [](std::uint32_t) { return true; });
    }

    // Places on rings, evenly spread, where a ring of another group is near; the best come first. With `all` there are
    // more places, and none on the largest group.
    std::vector<Candidate> candidates(bool all) {
        std::vector<Candidate> out;
        if (all && !near_) near_ = graph_.near_others(kNeighbourReach * width_);
        std::vector<std::uint32_t> group(graph_.size()); // of each ring
        for (std::uint32_t r = 0; r < group.size(); ++r) group[r] = groups_.root(r);
        const std::uint32_t largest = largest_of(group);
        for (std::uint32_t r = 0; r < graph_.size(); ++r) {
            if (group[r] == largest && all) continue;
            const double l = graph_.length(r);
            const auto n = static_cast<int>(all ? std::max(kPlaces, l / (kLink * width_)) : kPlaces);
            const auto apart = [&](std::uint32_t other) { return group[other] != group[r]; };
            std::size_t stretch = 0;
            for (int k = 0; k < n; ++k) {
                if (all) k += places_without(r, l * (k + 0.5) / n, l / n, stretch);
                if (k >= n) break;
                const double s = l * (k + 0.5) / n;
                const Vec2 here = graph_.at(r, s);
                if (*hung_ && (*hung_)(here) > may_hang_) continue;
                const auto there = graph_.nearest(here, kNeighbourReach * width_, apart);
                if (!there || there->distance == 0) continue;
                const Vec2 across = (1 / there->distance) * (there->point - here);
                const double bead = std::min(graph_.width(r, s), graph_.width(there->ring, there->s));
                // deviation from a distance of one bead, and from the width of one
                const double faults = std::abs(there->distance - width_) + std::max(0.0, width_ - bead);
                out.push_back({r, there->ring, s, across, std::min(bead, width_), faults});
            }
        }
        std::stable_sort(out.begin(), out.end(),
                         [](const Candidate& a, const Candidate& b) { return a.faults < b.faults; });
        return out;
    }

    // Places lie `step` mm apart along ring r. Returns how many to skip from the one at s to the first that may have a
    // neighbour. `stretch` counts up through the stretches of the ring.
    [[nodiscard]] int places_without(std::uint32_t r, double s, double step, std::size_t& stretch) const {
        const auto& near = (*near_)[r];
        while (stretch < near.size() && near[stretch].to < s) ++stretch;
        const double next = stretch < near.size() ? near[stretch].from : graph_.length(r);
        return std::max(0, static_cast<int>(std::ceil((next - s) / step)));
    }

    // The group with the most rings, the first of equals.
    static std::uint32_t largest_of(const std::vector<std::uint32_t>& group) {
        std::vector<std::uint32_t> count(group.size(), 0);
        for (const std::uint32_t g : group) ++count[g];
        return static_cast<std::uint32_t>(std::max_element(count.begin(), count.end()) - count.begin());
    }

    // Sets the window of `half` on each side of the candidate's place, and the one straight across on the other ring.
    // So the two links run side by side like beads. False if there is no such window.
    bool make(const Candidate& c, double half, Bridge& b) const {
        const double s0 = c.s - half, s1 = c.s + half;
        if (4 * half > graph_.length(c.a)) return false;
        const Vec2 a0 = graph_.at(c.a, s0), a1 = graph_.at(c.a, s1);
        const auto opposite = [&](Vec2 a) {
            return graph_.first_hit(a, c.across, 0, kNeighbourReach * width_,
                                    [&](std::uint32_t ring) { return ring == c.b; });
        };
        const auto p = opposite(a0), q = opposite(a1);
        if (!p || !q) return false;
        const double l = graph_.length(c.b);
        double ahead = std::fmod(q->s - p->s, l); // from p forward to q
        if (ahead < 0) ahead += l;
        b.parallel = ahead < l / 2;
        const double gone = b.parallel ? ahead : l - ahead;
        if (gone < 2 * half / kAlike || gone > 2 * half * kAlike) return false;
        const double t0 = b.parallel ? p->s : q->s;
        b.ring[0] = c.a;
        b.ring[1] = c.b;
        b.s0[0] = s0;
        b.s1[0] = s1;
        b.s0[1] = t0;
        b.s1[1] = t0 + gone;
        for (const int k : {0, 1}) {
            b.begin[k] = graph_.at(b.ring[k], b.s0[k]);
            b.end[k] = graph_.at(b.ring[k], b.s1[k]);
        }
        return true;
    }

    [[nodiscard]] bool fits(const Bridge& b, double half) const {
        for (const int k : {0, 1})
            if (!splices_.free(b.ring[k], b.s0[k] - half / 2, b.s1[k] + half / 2)) return false;
        const geom::Segment u = b.link(0), v = b.link(1);
        if (geom::cross_properly(u.a, u.b, v.a, v.b)) return false;
        for (const auto& l : {u, v}) {
            if (geom::distance(l.a, l.b) > kNeighbourReach * width_) return false;
            // not quite to the ends, which lie on rings
            if (graph_.crosses(geom::lerp(l.a, l.b, kLinkEnd), geom::lerp(l.b, l.a, kLinkEnd))) return false;
            if (!clear(l)) return false;
        }
        return true;
    }

    RingGraph graph_;
    const OutlineEdges* outline_;
    double width_;
    bool stay_inside_ = true;
    int may_hang_ = 0; // the largest value of hung_ at a link
    Splices splices_;
    geom::DisjointSets& groups_; // of rings
    std::optional<std::vector<std::vector<Stretch>>>
        near_; // per ring, stretches near others; set once all places are tried
    const Hanging* hung_;
    std::vector<char> over_air_; // per ring; empty if nothing hangs
};

} // namespace

OutlineEdges::OutlineEdges(const polygon::Loops& outline, double cell)
    : edge(polygon::segments(outline)), grid(edge, cell) {}

std::vector<Curve> join_rings(const rings::Rings& rings, double width, const OutlineEdges& outline, bool spirals,
                              const Hanging& hung) {
    if (rings.size() == 0) return {};
    return Joiner(rings, width, outline, hung).run(spirals);
}

std::vector<Curve> join_rings(const rings::Rings& rings, double width, const Loops& outline, bool spirals,
                              const Hanging& hung) {
    return join_rings(rings, width, OutlineEdges(outline, 1.5 * width), spirals, hung);
}

void note_unjoined(const std::vector<toolpath::Curve>& curves, Notes& notes) {
    if (curves.size() < 2) return;
    const auto more = curves.size() - 1;
    const Vec2 p = curves.back().points.front();
    notes.push_back({NoteCode::ring_unjoined, static_cast<double>(more), more, -1, p.x, p.y});
}

} // namespace filum::fill::join
