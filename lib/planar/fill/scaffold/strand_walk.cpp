#include "fill/scaffold/strand_walk.hpp"

#include "base/none.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace filum::fill::scaffold {

namespace {

constexpr double kStrand = 4; // passing a strand again costs this many times its length

class Walker {
  public:
    // `lean`: strands above count as nearer by this share of the way; if it is negative, strands below
    Walker(const StrandGraph& g, double lean)
        : g_(g), lean_(lean), laid_(g.strands, 0), passed_(g.arcs.size(), 0), cost_(g.node.size(), 0),
          seen_(g.node.size(), 0), before_(g.node.size()) {}

    // Walks from the node `from` to the strand end `first` (kNone: to the nearest one), then on until every strand is
    // visited.
    StrandWalk run(std::uint32_t from, std::uint32_t first) {
        out_.trails.emplace_back();
        std::uint32_t at = from;
        for (std::size_t left = g_.strands; left > 0; --left) {
            std::uint32_t to = search(at, first);
            if (to == kNone && first != kNone) to = search(at, kNone); // the boundary does not lead to `first`
            first = kNone;
            at = to != kNone ? go(at, to) : begin_anew();
            at = lay(at);
        }
        return std::move(out_);
    }

  private:
    [[nodiscard]] bool is_open(std::uint32_t node) const { return node < 2 * g_.strands && laid_[node / 2] == 0; }

    // The cheapest end of an unvisited strand to reach, or `goal` if that is given; kNone if there is none.
    std::uint32_t search(std::uint32_t from, std::uint32_t goal) {
        ++round_;
        using Item = std::pair<double, std::uint32_t>;
        std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
        const auto reach = [&](std::uint32_t node, double cost, Step by) {
            if (seen_[node] >= 2 * round_ || (seen_[node] == 2 * round_ - 1 && cost_[node] <= cost)) return;
            seen_[node] = 2 * round_ - 1;
            cost_[node] = cost;
            before_[node] = by;
            queue.emplace(cost, node);
        };
        reach(from, 0, {});
        std::uint32_t best = kNone;
        double least = std::numeric_limits<double>::infinity();
        while (!queue.empty()) {
            const auto [cost, node] = queue.top();
            queue.pop();
            if (seen_[node] == 2 * round_) continue;
            seen_[node] = 2 * round_;
            if (cost * (1 - std::abs(lean_)) > least) break;
            if (goal != kNone ? node == goal : is_open(node)) {
                const double up = g_.node[node].y - g_.node[from].y;
                const double c = goal != kNone ? cost : cost * (1 - (up > 0 ? lean_ : up < 0 ? -lean_ : 0));
                if (c < least) {
                    least = c;
                    best = node;
                }
                continue;
            }
            for (const std::uint32_t a : g_.arcs_at[node]) {
                const double c = cost + g_.arcs[a].length;
                const bool against = g_.arcs_at[node][1] != a;
                reach(against ? g_.arcs[a].from : g_.arcs[a].to, c, {a, false, against});
            }
            if (node < 2 * g_.strands && laid_[node / 2] != 0)
                reach(node ^ 1U, cost + kStrand * g_.strand_length(node / 2), {node / 2, true, node % 2 == 1});
        }
        return best;
    }

    // The node where a step begins.
    [[nodiscard]] std::uint32_t tail(const Step& s) const {
        if (s.strand) return 2 * s.id + (s.against ? 1 : 0);
        return s.against ? g_.arcs[s.id].to : g_.arcs[s.id].from;
    }

    std::uint32_t go(std::uint32_t from, std::uint32_t to) {
        std::vector<Step> steps;
        for (std::uint32_t n = to; n != from; n = tail(before_[n])) steps.push_back(before_[n]);
        std::reverse(steps.begin(), steps.end());
        for (const Step& s : steps) {
            out_.trails.back().push_back(s);
            if (s.strand) {
                out_.again += g_.strand_length(s.id);
                continue;
            }
            out_.along += g_.arcs[s.id].length;
            if (passed_[s.id]++ > 0) out_.again += g_.arcs[s.id].length;
        }
        return to;
    }

    std::uint32_t lay(std::uint32_t end) {
        laid_[end / 2] = 1;
        out_.trails.back().push_back({end / 2, true, end % 2 == 1});
        return end ^ 1U;
    }

    // Begins a new trail at the first unvisited strand: no way leads to the loops that it ends on.
    std::uint32_t begin_anew() {
        if (!out_.trails.back().empty()) out_.trails.emplace_back();
        return 2 * static_cast<std::uint32_t>(std::find(laid_.begin(), laid_.end(), 0) - laid_.begin());
    }

    const StrandGraph& g_;
    double lean_;
    std::vector<char> laid_;            // per strand
    std::vector<std::uint32_t> passed_; // per arc, how often
    std::vector<double> cost_;          // per node, in the current search:
    std::vector<std::uint64_t> seen_;   // 2 * round - 1: reached, 2 * round: settled
    std::vector<Step> before_;          //
    std::uint64_t round_ = 0;
    StrandWalk out_;
};

} // namespace

StrandWalk strand_walk(const StrandGraph& g) {
    StrandWalk best;
    if (g.strands == 0) return best;
    const auto last = static_cast<std::uint32_t>(2 * g.strands - 1);
    std::vector<std::uint32_t> first{0, 1, last, last - 1};
    if (g.start) first.insert(first.begin(), kNone);
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t f : first)
        for (const double lean : {0.0, 0.25, -0.25}) {
            StrandWalk walk = Walker(g, lean).run(g.start ? *g.start : f, f);
            const double cost = walk.along + walk.again;
            const bool fewer = walk.trails.size() < best.trails.size();
            if (!best.trails.empty() && !fewer && (walk.trails.size() > best.trails.size() || cost >= least)) continue;
            least = cost;
            best = std::move(walk);
        }
    return best;
}

} // namespace filum::fill::scaffold
