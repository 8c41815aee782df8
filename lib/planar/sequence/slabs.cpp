#include "sequence/slabs.hpp"

#include <algorithm>

namespace filum::sequence {

namespace {

// The arcs within first to last - 1, numbered from `first`.
Arcs part(const Arcs& a, Index first, Index last) {
    Arcs out;
    for (Index v = first; v < last; ++v) {
        for (const Index w : a[v])
            if (w >= first && w < last) out.to.push_back(w - first);
        out.start.push_back(static_cast<Index>(out.to.size()));
    }
    return out;
}

Slab slab(const Graph& g, const Columns& columns, Index first, Index last) {
    Slab s;
    s.first = first;
    s.g.node.assign(g.node.begin() + first, g.node.begin() + last);
    s.g.up = part(g.up, first, last);
    s.g.down = part(g.down, first, last);
    s.g.after = part(g.after, first, last);
    s.g.before = part(g.before, first, last);
    std::vector<Index> column(columns.member.size(), kNone);
    for (Index v = first; v < last; ++v) {
        Index& c = column[columns.of[v]];
        if (c == kNone) {
            c = static_cast<Index>(s.columns.member.size());
            s.columns.member.emplace_back();
        }
        s.columns.member[c].push_back(v - first);
        s.columns.of.push_back(c);
    }
    return s;
}

} // namespace

namespace {

// Per layer: whether a link leads over it, from a layer below to one above. A slab must not end there, as it would
// miss the link.
std::vector<char> crossed(const Graph& g) {
    std::vector<char> out(g.size() == 0 ? 0 : g.node.back().layer + 1, 0);
    for (Index u = 0; u < g.size(); ++u)
        for (const Index v : g.up[u])
            for (Index layer = g.node[u].layer + 1; layer < g.node[v].layer; ++layer) out[layer] = 1;
    return out;
}

} // namespace

std::vector<Slab> slabs(const Graph& g, const Columns& columns, std::size_t most) {
    const std::vector<char> closed = crossed(g);
    std::vector<Index> layer; // the first region of each, and one past the end
    for (Index v = 0; v < g.size(); ++v)
        while (layer.size() <= g.node[v].layer) layer.push_back(v);
    layer.push_back(g.size());
    std::vector<Slab> out;
    // number of the slab, from 1, that last contained the column
    std::vector<std::size_t> seen(columns.member.size(), 0);
    for (std::size_t bottom = 0; bottom + 1 < layer.size();) {
        std::size_t many = 0, top = bottom; // columns of the layers bottom to top - 1
        for (; top + 1 < layer.size(); ++top) {
            std::size_t more = many;
            for (Index v = layer[top]; v < layer[top + 1]; ++v)
                if (auto& s = seen[columns.of[v]]; s != out.size() + 1) {
                    s = out.size() + 1;
                    ++more;
                }
            if (top > bottom + 1 && closed[top - 1] == 0 && more * (layer[top + 1] - layer[bottom]) > most) break;
            many = more;
        }
        out.push_back(slab(g, columns, layer[bottom], layer[top]));
        if (top + 1 == layer.size()) break;
        bottom = top - 1;
    }
    return out;
}

} // namespace filum::sequence
