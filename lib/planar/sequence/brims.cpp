#include "sequence/brims.hpp"

#include "base/error.hpp"

#include <algorithm>

namespace filum::sequence {

std::vector<Pair> brims(std::span<const polygon::Region> regions) {
    std::vector<Pair> out;
    for (const polygon::Region& r : regions) {
        if (r.brim < 0) continue;
        const auto brim = static_cast<std::size_t>(r.brim);
        if (brim >= regions.size() || brim == r.id || regions[brim].layer != r.layer || !regions[brim].below.empty())
            throw Error(Exit::bad_input, "cannot sequence region '" + std::to_string(r.id) +
                                             "': its brim is not a region of the same layer");
        const bool taken = std::any_of(out.begin(), out.end(), [&](const Pair& p) { return p.first == r.brim; });
        if (!taken && r.below.empty() && regions[brim].tool == r.tool) out.emplace_back(static_cast<Index>(brim), r.id);
    }
    return out;
}

void hold_together(std::span<const Pair> brims, Graph& g) {
    std::vector<Pair> more;
    for (const auto& [brim, region] : brims)
        for (const Index waiting : g.after[brim])
            if (waiting != region) more.emplace_back(region, waiting);
    if (!more.empty()) add_precedence(g, std::move(more));
}

void begin_with(std::span<const Pair> brims, Graph& g, Plan& p) {
    if (brims.empty()) return;
    std::vector<Pair> links(brims.begin(), brims.end());
    for (Index v = 0; v < g.size(); ++v)
        for (const Index w : g.up[v]) links.emplace_back(v, w);
    g.up = arcs(g.size(), std::move(links));
    g.down = reversed(g.up);
    for (const auto& [brim, region] : brims) {
        p.order.erase(std::find(p.order.begin(), p.order.end(), brim));
        p.order.insert(std::find(p.order.begin(), p.order.end(), region), brim);
    }
    p.cost = cost(g, p.order);
    const auto fewer = static_cast<Index>(brims.size());
    for (Index* bound : {&p.path_cover, &p.relaxation, &p.bound}) *bound -= std::min(*bound, fewer);
}

std::vector<Index> skirts(std::span<const polygon::Region> regions) {
    std::vector<bool> is_brim(regions.size(), false);
    for (const polygon::Region& r : regions)
        if (r.brim >= 0 && static_cast<std::size_t>(r.brim) < regions.size())
            is_brim[static_cast<std::size_t>(r.brim)] = true;
    std::vector<Index> out;
    for (const polygon::Region& r : regions)
        if (r.is == polygon::RegionClass::rim && !is_brim[r.id]) out.push_back(r.id);
    return out;
}

void put_first(std::span<const Index> skirts, const Graph& g, Plan& p) {
    if (skirts.empty()) return;
    for (const Index skirt : skirts) {
        if (!g.before[skirt].empty()) continue;
        const auto of_tool = [&](Index v) { return g.node[v].tool == g.node[skirt].tool; };
        const auto to = std::find_if(p.order.begin(), p.order.end(), of_tool);
        const auto from = std::find(to, p.order.end(), skirt);
        std::rotate(to, from, std::next(from));
    }
    p.cost = cost(g, p.order);
}

} // namespace filum::sequence
