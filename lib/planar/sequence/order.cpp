#include "sequence/order.hpp"

#include "base/error.hpp"
#include "geom/nearest_points.hpp"

#include <algorithm>

namespace filum::sequence {

bool continues(const Graph& g, Index u, Index v) {
    const auto up = g.up[u];
    return std::binary_search(up.begin(), up.end(), v);
}

Cost cost(const Graph& g, std::span<const Index> order) {
    Cost c;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && g.node[order[i - 1]].tool != g.node[order[i]].tool) ++c.changes;
        if (i > 0 && continues(g, order[i - 1], order[i])) continue;
        ++c.strokes;
        if (i > 0) c.travel += geom::distance(g.node[order[i - 1]].centre, g.node[order[i]].centre);
    }
    return c;
}

bool less(const Cost& a, const Cost& b, Priority first) {
    const auto key = [&](const Cost& c) {
        return first == Priority::strokes ? std::pair(c.strokes, c.changes) : std::pair(c.changes, c.strokes);
    };
    return key(a) < key(b);
}

void check(const Graph& g, std::span<const Index> order) {
    const auto fail = [](const std::string& why) { throw Error(Exit::failure, "internal error: the order " + why); };
    if (order.size() != g.size()) fail("does not contain every region");
    std::vector<Index> place(g.size(), kNone);
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (order[i] >= g.size() || place[order[i]] != kNone) fail("contains a region twice");
        place[order[i]] = static_cast<Index>(i);
    }
    for (Index u = 0; u < g.size(); ++u)
        for (const Index v : g.after[u])
            if (place[u] > place[v])
                fail("prints region " + std::to_string(v) + " before region " + std::to_string(u) +
                     ", which it must follow");
}

namespace {

struct LayerEnds {
    Index first = kNone, last = kNone;
};

// A state of the dynamic program over layers: the greatest number of links if a region is the first, or the last, of
// its layer.
struct LayerState {
    Index links = 0;
    Index from =
        kNone; // of a first: the last region of the layer below that it continues; of a last: its layer's first
};

bool several_tools(const Graph& g, const std::vector<Index>& layer) {
    return std::any_of(layer.begin(), layer.end(),
                       [&](Index v) { return g.node[v].tool != g.node[layer.front()].tool; });
}

// Whether a layer that begins with `first` cannot end with `last`: it is the same region or, in a layer with several
// tools, a region of the same tool.
bool excludes(const Graph& g, const std::vector<Index>& layer, Index first, Index last) {
    return first == last || (several_tools(g, layer) && g.node[first].tool == g.node[last].tool);
}

// The best first region of a layer, and the best one that a last region may have that excludes it.
std::pair<Index, Index> best_firsts(const Graph& g, const std::vector<Index>& layer,
                                    const std::vector<LayerState>& first) {
    Index one = kNone, two = kNone;
    for (const Index v : layer)
        if (one == kNone || first[v].links > first[one].links) one = v;
    for (const Index v : layer)
        if (!excludes(g, layer, one, v) && (two == kNone || first[v].links > first[two].links)) two = v;
    return {one, two};
}

// The first and the last region of every layer such that as many as possible are linked.
std::vector<LayerEnds> layer_ends(const Graph& g, const std::vector<std::vector<Index>>& layers) {
    std::vector<LayerState> first(g.size()), last(g.size());
    Index best = kNone; // the best last region of the layer below
    for (const auto& layer : layers) {
        for (const Index v : layer) {
            first[v] = {best == kNone ? 0 : last[best].links, best};
            for (const Index u : g.down[v]) // a region that is several layers high begins farther below
                if (g.node[u].layer == g.node[best].layer && last[u].links + 1 > first[v].links)
                    first[v] = {last[u].links + 1, u};
        }
        const auto [one, two] = best_firsts(g, layer, first);
        best = kNone;
        for (const Index v : layer) {
            const Index f = layer.size() == 1 || !excludes(g, layer, one, v) ? one : two;
            last[v] = {first[f].links, f};
            if (best == kNone || last[v].links > last[best].links) best = v;
        }
    }
    std::vector<LayerEnds> out(layers.size());
    for (std::size_t i = layers.size(); i-- > 0;) {
        out[i] = {last[best].from, best};
        best = first[out[i].first].from;
    }
    return out;
}

// Appends the regions between the first and the last one of a layer with several tools, tool by tool.
void append_by_tool(const Graph& g, const std::vector<Index>& layer, const LayerEnds& ends, Order& out) {
    const auto rank = [&](Index v) {
        const Index tool = g.node[v].tool;
        return std::pair(tool == g.node[ends.first].tool ? 0 : tool == g.node[ends.last].tool ? 2 : 1, tool);
    };
    std::vector<Index> rest;
    for (const Index v : layer)
        if (v != ends.first && v != ends.last) rest.push_back(v);
    std::stable_sort(rest.begin(), rest.end(), [&](Index a, Index b) { return rank(a) < rank(b); });
    for (std::size_t from = 0, to = 0; from < rest.size(); from = to) {
        std::vector<geom::Vec2> centre;
        for (; to < rest.size() && rank(rest[to]) == rank(rest[from]); ++to) centre.push_back(g.node[rest[to]].centre);
        geom::NearestPoints left(centre);
        for (std::uint32_t i = 0; i < centre.size(); ++i) left.insert(i);
        while (!left.empty()) {
            const std::uint32_t i = *left.nearest(g.node[out.back()].centre);
            left.remove(i);
            out.push_back(rest[from + i]);
        }
    }
}

// Appends the regions of a layer: the first, then always the nearest, the last one at the end. With several tools those
// of the first region's tool come first and those of the last region's tool last.
void append_nearest(const Graph& g, const std::vector<Index>& layer, const LayerEnds& ends, Order& out) {
    std::vector<geom::Vec2> centre;
    centre.reserve(layer.size());
    for (const Index v : layer) centre.push_back(g.node[v].centre);
    geom::NearestPoints left(centre);
    for (std::uint32_t i = 0; i < layer.size(); ++i)
        if (layer[i] != ends.first && layer[i] != ends.last) left.insert(i);
    out.push_back(ends.first);
    if (several_tools(g, layer)) {
        append_by_tool(g, layer, ends, out);
    } else {
        while (!left.empty()) {
            const std::uint32_t i = *left.nearest(g.node[out.back()].centre);
            left.remove(i);
            out.push_back(layer[i]);
        }
    }
    if (ends.last != ends.first) out.push_back(ends.last);
}

} // namespace

Order layer_order(const Graph& g) {
    std::vector<std::vector<Index>> layers;
    for (Index v = 0; v < g.size(); ++v) {
        if (layers.empty() || g.node[v].layer != g.node[layers.back().back()].layer) layers.emplace_back();
        layers.back().push_back(v);
    }
    const auto ends = layer_ends(g, layers);
    Order out;
    for (std::size_t i = 0; i < layers.size(); ++i) append_nearest(g, layers[i], ends[i], out);
    return out;
}

} // namespace filum::sequence
