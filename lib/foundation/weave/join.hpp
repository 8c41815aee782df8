// Joins curves at the places where they face each other, in the order of what it costs (docs/algorithms/weave.md).
#pragma once

#include "geom/disjoint_sets.hpp"

#include <cstdint>
#include <queue>
#include <vector>

namespace filum::weave {

// Joins at sites in their order, until one group is left. A site names two curves, a and b. A site whose curves are
// in one group already is skipped. make(site) links the two curves if there is room.
template <class Sites, class Make>
void join(geom::DisjointSets& groups, const Sites& sites, const Make& make) {
    for (const auto& site : sites) {
        if (groups.sets() <= 1) return;
        if (groups.root(site.a) != groups.root(site.b)) make(site);
    }
}

// What to do with the cheapest site.
enum class Verdict : std::uint8_t {
    join,  // now
    later, // its cost has grown, so another site may be cheaper
    never
};

// Joins at the cheapest site first, where the cost of a site depends on what was joined before (Kruskal 1956 with costs
// that grow). judge(site) updates the cost of a site and returns what to do with it. make(site) links its curves.
template <class Site, class Order, class Judge, class Make>
void join_cheapest(std::priority_queue<Site, std::vector<Site>, Order>& queue, const Judge& judge, const Make& make) {
    while (!queue.empty()) {
        Site site = queue.top();
        queue.pop();
        const Verdict verdict = judge(site);
        if (verdict == Verdict::later) queue.push(site);
        if (verdict == Verdict::join) make(site);
    }
}

} // namespace filum::weave
