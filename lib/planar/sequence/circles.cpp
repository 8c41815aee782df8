#include "sequence/cutting_planes.hpp"

#include <algorithm>
#include <queue>

namespace filum::sequence {

namespace {

constexpr std::uint64_t kMostWork = 4'000'000; // per call; the next one continues where it stopped

} // namespace

// Searches shortest paths over the runs of regions without a break. From the lowest region of a run a path leads for
// free to what must follow it in each other column, and from a run to the next lower one of its column for the price
// of the break in between. A path back to its start for less than 1 is a violated circle.
struct CuttingPlanes::CircleSearch {
    struct Run {
        Index column, bottom; // column; place of its lowest region
        double below = 0;     // price of the break below it; infinite for the lowest
    };
    struct PathLabel {
        double cost;
        Index from = kNone; // previous run
        Index head = 0;     // place where the path entered its column
        bool entered = false;
        bool done = false;
        Index trip = kNone; // the start for which the labels hold
    };
    struct QueueEntry {
        double cost;
        Index run;
        friend bool operator<(const QueueEntry& a, const QueueEntry& b) {
            return a.cost > b.cost || (a.cost == b.cost && a.run > b.run);
        }
    };
    CuttingPlanes& cuts;
    std::vector<Run> run;
    std::vector<Index> of; // the run of each region
    std::vector<PathLabel> reached;
    std::priority_queue<QueueEntry> open;

    explicit CircleSearch(CuttingPlanes& c) : cuts(c), of(c.g_.size()) {
        for (Index k = 0; k < cuts.columns_.member.size(); ++k)
            for (Index p = 0; p < cuts.columns_.member[k].size(); ++p) {
                const Index v = cuts.columns_.member[k][p];
                if (cuts.level_[v] == p) run.push_back({k, p, p == 0 ? 1 : cuts.broken(k, p - 1, p)});
                of[v] = static_cast<Index>(run.size() - 1);
            }
        reached.resize(run.size());
    }

    void reach(Index trip, Index to, double cost, Index from, Index head, bool entered) {
        PathLabel& r = reached[to];
        if (cost > 1 - kLeastViolation || (r.trip == trip && r.cost <= cost)) return;
        r = {cost, from, head, entered, false, trip};
        open.push({cost, to});
    }

    // Labels everything reached from `start` for less than 1; true once a path returns to it.
    bool around(Index start) {
        open = {};
        leave(start, start, 0);
        while (!open.empty()) {
            const auto [cost, i] = open.top();
            open.pop();
            PathLabel& r = reached[i];
            if (r.done || r.cost != cost) continue;
            if (i == start) return true;
            r.done = true;
            descend(start, i);
            leave(start, i, cost);
        }
        return false;
    }

    void descend(Index trip, Index i) {
        const PathLabel& r = reached[i];
        if (run[i].bottom > 0) reach(trip, i - 1, r.cost + run[i].below, i, r.head, false);
    }

    void leave(Index trip, Index i, double cost) {
        const Index v = cuts.columns_.member[run[i].column][run[i].bottom];
        for (Index c = 0; c < cuts.columns_.member.size(); ++c) {
            ++cuts.work_;
            const Index head = c == run[i].column ? kNone : cuts.successors_.first(v, c);
            if (head != kNone) reach(trip, of[cuts.columns_.member[c][head]], cost, i, head, true);
        }
    }

    // The stretches of the path back to `start`, in the order of their precedence.
    [[nodiscard]] Stretches stretches(Index start) const {
        Stretches out;
        Index foot = start;
        for (Index i = start;;) {
            const PathLabel& r = reached[i];
            if (!r.entered) {
                i = r.from;
                continue;
            }
            out.push_back({run[i].column, run[foot].bottom, r.head});
            foot = i = r.from;
            if (i == start) break;
        }
        std::reverse(out.begin(), out.end());
        return out;
    }
};

std::vector<CuttingPlanes::Violation> CuttingPlanes::circles() {
    CircleSearch w(*this);
    std::vector<Violation> out;
    const auto n = static_cast<Index>(w.run.size());
    const std::uint64_t limit = work_ + kMostWork;
    for (Index tried = 0; tried < n && work_ < limit; ++tried) {
        const Index start = turn_++ % n;
        if (!w.around(start)) continue;
        Stretches s = w.stretches(start);
        for (std::size_t k = 0; k < s.size(); ++k) { // raise the feet as far as the following heads allow
            const Stretch& next = s[(k + 1) % s.size()];
            while (s[k].foot < s[k].head &&
                   successors_.first(columns_.member[s[k].column][s[k].foot + 1], next.column) <= next.head)
                ++s[k].foot;
        }
        out.push_back({1 - w.reached[start].cost, std::move(s), 1});
    }
    return out;
}

} // namespace filum::sequence
