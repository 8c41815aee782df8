#include "sequence/climb.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace filum::sequence {

namespace {

// Rank of a region as the start of a stroke, the best first: whether a region is ahead where the stroke would end, the
// value of the rule, and the number.
using Start = std::tuple<bool, std::int64_t, Index>;

// The state of printing: what is printed and what may follow.
struct Progress {
    const Graph& g;
    StartRule rule;
    std::vector<Index> waiting; // per region: number of unprinted predecessors
    std::vector<char> printed;
    std::vector<Index> height;                // number of regions on the longest path up by links
    std::vector<Index> since;                 // number of strokes printed when a region became ready
    std::set<Start> starts;                   // of the regions that are ready
    std::vector<Start> start;                 // by region
    std::map<Index, std::set<Start>> of_tool; // the same by tool
    std::vector<std::vector<Index>> blocking; // starts whose stroke ends waiting for this region
    Index strokes = 0;
    Order order;

    Progress(const Graph& graph, StartRule c);
    void print(Index v);
    [[nodiscard]] Index next(Index u) const;
    void look(Index s);
    void go(Index s);
    void forget(Index v) {
        starts.erase(start[v]);
        of_tool[g.node[v].tool].erase(start[v]);
    }
    [[nodiscard]] Index best(KeepTool keep);
};

Progress::Progress(const Graph& graph, StartRule c)
    : g(graph), rule(c), waiting(g.size()), printed(g.size(), 0), height(g.size(), 1), since(g.size(), 0),
      start(g.size(), {false, 0, kNone}), blocking(g.size()) {
    for (Index v = g.size(); v-- > 0;) {
        for (const Index w : g.up[v]) height[v] = std::max(height[v], height[w] + 1);
        waiting[v] = static_cast<Index>(g.before[v].size());
    }
    order.reserve(g.size());
    for (Index v = 0; v < g.size(); ++v)
        if (waiting[v] == 0) look(v);
}

// The region to which the stroke continues from u: the ready one with the longest path ahead; ties: the lower number;
// kNone if none.
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

// Prints ahead from a ready region, records how far that leads and for what it waits there, and undoes it.
void Progress::look(Index s) {
    const std::size_t mark = order.size();
    for (Index v = s; v != kNone; v = next(v)) print(v);
    const auto length = static_cast<std::int64_t>(order.size() - mark);
    Index blocker = kNone;
    for (const Index v : g.up[order.back()]) {
        if (printed[v] != 0 || blocker != kNone) continue;
        for (const Index p : g.before[v])
            if (printed[p] == 0) {
                blocker = p;
                break;
            }
    }
    while (order.size() > mark) {
        for (const Index w : g.after[order.back()]) ++waiting[w];
        printed[order.back()] = 0;
        order.pop_back();
    }
    const std::int64_t first = rule == StartRule::longest  ? -length
                               : rule == StartRule::lowest ? std::int64_t{g.node[s].layer}
                                                           : -std::int64_t{since[s]};
    start[s] = {blocker != kNone, first, s};
    starts.insert(start[s]);
    of_tool[g.node[s].tool].insert(start[s]);
    if (blocker != kNone) blocking[blocker].push_back(s);
}

// Prints the stroke from s and updates the starts that this affects.
void Progress::go(Index s) {
    const std::size_t mark = order.size();
    for (Index v = s; v != kNone; v = next(v)) print(v);
    ++strokes;
    std::vector<Index> again;
    for (std::size_t i = mark; i < order.size(); ++i) {
        forget(order[i]);
        again.insert(again.end(), blocking[order[i]].begin(), blocking[order[i]].end());
        for (const Index w : g.after[order[i]])
            if (waiting[w] == 0 && printed[w] == 0 && since[w] == 0) {
                since[w] = strokes;
                again.push_back(w);
            }
    }
    std::sort(again.begin(), again.end());
    again.erase(std::unique(again.begin(), again.end()), again.end());
    for (const Index v : again) {
        if (printed[v] != 0) continue;
        forget(v);
        look(v);
    }
}

// The start of the next stroke.
Index Progress::best(KeepTool keep) {
    if (keep != KeepTool::never && !order.empty()) {
        const auto& same = of_tool[g.node[order.back()].tool];
        if (!same.empty() && (keep == KeepTool::always || !std::get<bool>(*same.begin())))
            return std::get<Index>(*same.begin());
    }
    return std::get<Index>(*starts.begin());
}

} // namespace

Order climb(const Graph& g, StartRule rule, KeepTool keep) {
    Progress s(g, rule);
    while (!s.starts.empty()) s.go(s.best(keep));
    return std::move(s.order);
}

} // namespace filum::sequence
