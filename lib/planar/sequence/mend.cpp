#include "sequence/mend.hpp"

#include <algorithm>
#include <random>

namespace filum::sequence {

namespace {

constexpr Index kMostMoved = 4000; // regions that a change may move, which takes as many steps

struct StrokeJoiner {
    const Graph& g;
    Order& order;
    std::vector<Index> place;
    std::mt19937_64 random{1};
    std::uint64_t work = 0;
    // Data of a change: how much of the first stroke, from its start, comes before a region; and regions in three
    // parts.
    std::vector<Index> held;
    Order before, behind, fresh;

    StrokeJoiner(const Graph& graph, Order& o) : g(graph), order(o), place(graph.size()), held(graph.size(), 0) {
        for (Index i = 0; i < order.size(); ++i) place[order[i]] = i;
    }

    [[nodiscard]] bool linked(Index i) const {
        return i > 0 && i < order.size() && continues(g, order[i - 1], order[i]);
    }

    // How much of the first stroke, lo to at, a region between the strokes or `v` waits for, directly or not.
    [[nodiscard]] Index holds(Index v, Index lo, Index at, bool direct) {
        Index most = 0;
        for (const Index p : g.before[v]) {
            const Index i = place[p];
            if (i > at && i < place[v])
                most = std::max(most, held[p]);
            else if (direct && i >= lo && i <= at)
                most = std::max(most, i - lo + 1);
        }
        work += g.before[v].size() + 1;
        return most;
    }

    // Tries to print v directly after u; returns the number of strokes saved.
    Index join(Index u, Index v) {
        const Index at = place[u], to = place[v];
        if (to - at > kMostMoved) return 0;
        Index lo = at;
        while (linked(lo) && at - lo < kMostMoved) --lo;
        for (Index i = at + 1; i < to; ++i) held[order[i]] = holds(order[i], lo, at, true);
        const Index cut = holds(v, lo, at, false); // this much of the first stroke must stay
        if (cut > at - lo) return 0;
        before.clear();
        behind.clear();
        for (Index i = at + 1; i < to; ++i) (held[order[i]] > cut ? behind : before).push_back(order[i]);
        Index end = to + 1; // end of the part of the second stroke that is moved
        const auto waits = [&](Index w) {
            return std::any_of(g.before[w].begin(), g.before[w].end(),
                               [&](Index p) { return place[p] > at && place[p] < to && held[p] > cut; });
        };
        while (linked(end) && end - to < kMostMoved && !waits(order[end])) ++end;
        return change(lo + cut, at, to, end);
    }

    // Reorders from .. end: regions that come before, the first stroke's part from .. at, the second's part to .. end,
    // the rest.
    Index change(Index from, Index at, Index to, Index end) {
        fresh.assign(before.begin(), before.end());
        fresh.insert(fresh.end(), order.begin() + from, order.begin() + at + 1);
        fresh.insert(fresh.end(), order.begin() + to, order.begin() + end);
        fresh.insert(fresh.end(), behind.begin(), behind.end());
        int gain = 0;
        for (Index i = from; i <= end; ++i) {
            gain -= linked(i) ? 1 : 0;
            if (i == 0 || i == order.size()) continue;
            const Index u = i == from ? order[i - 1] : fresh[i - 1 - from];
            gain += continues(g, u, i == end ? order[i] : fresh[i - from]) ? 1 : 0;
        }
        work += 2 * (end - from);
        if (gain < 0) return 0;
        std::copy(fresh.begin(), fresh.end(), order.begin() + from);
        for (Index i = from; i < end; ++i) place[order[i]] = i;
        return static_cast<Index>(gain);
    }

    // An unused link of a random region that starts a stroke or, every other time, ends one.
    [[nodiscard]] Pair draw() {
        const auto v = static_cast<Index>(random() % g.size());
        const bool start = random() % 2 == 0;
        const auto others = start ? g.down[v] : g.up[v];
        if (others.empty() || linked(start ? place[v] : place[v] + 1)) return {kNone, kNone};
        const Index u = others[random() % others.size()];
        return start ? Pair{u, v} : Pair{v, u};
    }
};

} // namespace

void mend(const Graph& g, Order& order, Index target, std::uint64_t budget, std::uint64_t& steps) {
    StrokeJoiner m(g, order);
    Index strokes = cost(g, order).strokes;
    while (strokes > target && m.work < budget) {
        m.work += 10; // of drawing
        const auto [u, v] = m.draw();
        if (u != kNone) strokes -= m.join(u, v);
    }
    steps += m.work;
}

} // namespace filum::sequence
