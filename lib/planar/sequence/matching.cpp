#include "sequence/matching.hpp"

#include <algorithm>

namespace filum::sequence {

namespace {

// The algorithm of Hopcroft and Karp (1973).
struct HopcroftKarp {
    const Arcs& links;
    std::vector<Index> next, previous; // the matching, from both sides
    std::vector<Index> level, at;      // per left node: its distance from the free ones, the next arc to try

    // Computes the distances of the left nodes from the free ones along alternating paths; true if a free right node
    // is reached.
    bool rank() {
        std::vector<Index> queue;
        std::fill(level.begin(), level.end(), kNone);
        for (Index u = 0; u < next.size(); ++u)
            if (next[u] == kNone && !links[u].empty()) {
                level[u] = 0;
                queue.push_back(u);
            }
        bool found = false;
        Index last = kNone; // the level of the shortest augmenting paths
        for (std::size_t i = 0; i < queue.size() && (!found || level[queue[i]] == last); ++i)
            for (const Index v : links[queue[i]]) {
                const Index w = previous[v];
                if (w == kNone) {
                    found = true;
                    last = level[queue[i]];
                } else if (level[w] == kNone) {
                    level[w] = level[queue[i]] + 1;
                    queue.push_back(w);
                }
            }
        return found;
    }

    // One augmenting path from u along the levels, depth first, without recursion.
    bool augment(Index from) {
        std::vector<Index> path{from};
        while (!path.empty()) {
            const Index u = path.back();
            if (at[u] == links.start[u + 1]) {
                level[u] = kNone; // a dead end in this phase
                path.pop_back();
                continue;
            }
            const Index v = links.to[at[u]], w = previous[v];
            if (w == kNone) {
                for (const Index p : path) {
                    next[p] = links.to[at[p]];
                    previous[next[p]] = p;
                }
                return true;
            }
            if (level[w] != kNone && level[w] == level[u] + 1 && at[w] != links.start[w + 1])
                path.push_back(w);
            else
                ++at[u];
        }
        return false;
    }
};

} // namespace

std::vector<Index> maximum_matching(const Arcs& links) {
    const std::size_t n = links.start.size() - 1;
    HopcroftKarp s{links, std::vector<Index>(n, kNone), std::vector<Index>(n, kNone), std::vector<Index>(n), {}};
    while (s.rank()) {
        s.at.assign(links.start.begin(), links.start.end() - 1);
        for (Index u = 0; u < n; ++u)
            if (s.next[u] == kNone && s.level[u] == 0) s.augment(u);
    }
    return s.next;
}

Index matched(const std::vector<Index>& next) {
    return static_cast<Index>(std::count_if(next.begin(), next.end(), [](Index v) { return v != kNone; }));
}

Index path_cover(const Graph& g) { return g.size() - matched(maximum_matching(g.up)); }

} // namespace filum::sequence
