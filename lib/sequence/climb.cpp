#include "sequence/climb.hpp"

#include <algorithm>
#include <tuple>

namespace filum::sequence {

namespace {

// What a stroke started at a region would do.
struct Run {
    Index length = 0;
    Index end = kNone;
    Index blocker = kNone; // what must be printed before it can go on; kNone: nothing lies ahead
    bool known = false;
};

// What is printed so far and what may follow.
struct Progress {
    const Graph& g;
    std::vector<Index> waiting; // how many of its predecessors a region still waits for
    std::vector<char> printed;
    std::vector<Index> height; // regions on the longest way up by links
    std::vector<Index> ready;  // unprinted, waiting for none
    std::vector<Run> run;      // cached, of ready regions
    Order order;

    explicit Progress(const Graph& graph);
    void print(Index v);
    [[nodiscard]] Index next(Index u) const;
    Run look(Index s);
    void go(Index s);
};

Progress::Progress(const Graph& graph)
    : g(graph), waiting(g.size()), printed(g.size(), 0), height(g.size(), 1), run(g.size()) {
    for (Index v = g.size(); v-- > 0;) {
        for (const Index w : g.up[v]) height[v] = std::max(height[v], height[w] + 1);
        waiting[v] = static_cast<Index>(g.before[v].size());
    }
    for (Index v = 0; v < g.size(); ++v)
        if (waiting[v] == 0) ready.push_back(v);
    order.reserve(g.size());
}

// Where the stroke goes from u: the ready region with the longest way ahead, ties to the lower id; kNone if none.
Index Progress::next(Index u) const {
    Index best = kNone;
    for (const Index v : g.up[u])
        if (waiting[v] == 0 && printed[v] == 0 && (best == kNone || height[v] > height[best])) best = v;
    return best;
}

void Progress::print(Index v) {
    printed[v] = 1;
    order.push_back(v);
    for (const Index w : g.after[v]) --waiting[w];
}

// Prints ahead, notes how far it came, and takes it back.
Run Progress::look(Index s) {
    Run r;
    r.known = true;
    const std::size_t mark = order.size();
    for (Index v = s; v != kNone; v = next(v)) print(v);
    r.length = static_cast<Index>(order.size() - mark);
    r.end = order.back();
    for (const Index v : g.up[r.end]) {
        if (printed[v] != 0) continue;
        for (const Index p : g.before[v])
            if (printed[p] == 0) {
                r.blocker = p;
                break;
            }
        if (r.blocker != kNone) break;
    }
    while (order.size() > mark) {
        for (const Index w : g.after[order.back()]) ++waiting[w];
        printed[order.back()] = 0;
        order.pop_back();
    }
    return r;
}

void Progress::go(Index s) {
    const std::size_t mark = order.size();
    for (Index v = s; v != kNone; v = next(v)) print(v);
    std::vector<Index> freed;
    for (std::size_t i = mark; i < order.size(); ++i)
        for (const Index w : g.after[order[i]])
            if (waiting[w] == 0 && printed[w] == 0) freed.push_back(w);
    std::sort(freed.begin(), freed.end());
    freed.erase(std::unique(freed.begin(), freed.end()), freed.end());
    std::erase_if(ready, [&](Index v) { return printed[v] != 0; });
    ready.insert(ready.end(), freed.begin(), freed.end());
    for (const Index v : ready)
        if (run[v].blocker != kNone && printed[run[v].blocker] != 0) run[v].known = false;
}

} // namespace

Order climb(const Graph& g, Choice choice) {
    Progress s(g);
    while (!s.ready.empty()) {
        Index best = kNone;
        std::tuple<bool, double, double, Index> least;
        for (const Index v : s.ready) {
            if (!s.run[v].known) s.run[v] = s.look(v);
            const Run& r = s.run[v];
            const double away = s.order.empty() ? 0 : geom::distance(g.node[s.order.back()].centre, g.node[v].centre);
            const double first = choice == Choice::longest  ? -static_cast<double>(r.length)
                                 : choice == Choice::lowest ? static_cast<double>(g.node[v].layer)
                                                            : 0.0;
            const std::tuple key{r.blocker != kNone, first, away, v};
            if (best == kNone || key < least) best = v, least = key;
        }
        s.go(best);
    }
    return std::move(s.order);
}

} // namespace filum::sequence
