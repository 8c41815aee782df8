#include "sequence/hanging.hpp"

#include "geom/disjoint_sets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::sequence {

namespace {

// mm; smaller differences of distances count as none, so that rounding does not choose a region
constexpr double kAlike = 0.001;

using Distances = std::vector<std::pair<double, Index>>;

// The regions with their connection by support.
struct SupportedParts {
    const Graph& g;
    const std::vector<Outline>& outlines;
    std::vector<Index> first;   // region of each layer, and one past the end
    std::vector<Index> covered; // per region: the layer of the lowest one that follows it; kNone if none does
    geom::DisjointSets set;

    SupportedParts(const Graph& graph, const std::vector<Outline>& o)
        : g(graph), outlines(o), covered(graph.size(), kNone), set(graph.size()) {
        for (Index v = 0; v < g.size(); ++v) {
            while (first.size() <= g.node[v].layer) first.push_back(v);
            for (const Index w : g.after[v]) {
                covered[v] = std::min(covered[v], g.node[w].layer);
                set.unite(v, w);
            }
        }
        first.push_back(g.size());
    }

    [[nodiscard]] bool hangs(Index v) const { return !g.node[v].bed && !g.node[v].carried; }

    // Distance between the boxes of two regions, a lower bound for that of their outlines.
    [[nodiscard]] double box_distance(Index v, Index u) const {
        return geom::distance(outlines[v].box, outlines[u].box);
    }

    // The region of the next lower layer nearest to v, and those equally near.
    [[nodiscard]] std::vector<Index> nearest_below(Index v) const {
        const Index layer = g.node[v].layer;
        Distances boxes, exact;
        for (Index u = first[layer - 1]; u < first[layer]; ++u) boxes.emplace_back(box_distance(v, u), u);
        std::sort(boxes.begin(), boxes.end());
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [box, u] : boxes) {
            if (box > least + kAlike) break;
            exact.emplace_back(distance(outlines[v], outlines[u]), u);
            least = std::min(least, exact.back().first);
        }
        std::vector<Index> out;
        for (const auto& [far, u] : exact)
            if (far <= least + kAlike) out.push_back(u);
        return out;
    }

    // Joins each part to the nearest one on the layer below its lowest one, and below a hanging region if the part has
    // a gap there, as above a support.
    void join_floating() {
        std::vector<Index> root(g.size());
        for (Index v = 0; v < g.size(); ++v) root[v] = set.root(v);
        std::vector<std::pair<Index, Index>> present; // roots, and layers of their parts
        for (Index v = 0; v < g.size(); ++v) present.emplace_back(root[v], g.node[v].layer);
        std::sort(present.begin(), present.end());
        const auto misses_layer_below = [&](Index v) {
            const std::pair<Index, Index> below{root[v], g.node[v].layer - 1};
            return !std::binary_search(present.begin(), present.end(), below);
        };
        for (Index v = first[1]; v < g.size(); ++v)
            if (hangs(v) && misses_layer_below(v))
                for (const Index u : nearest_below(v)) set.unite(u, v);
    }

    // The regions of `open` that v follows: all, or the nearest ones.
    [[nodiscard]] std::vector<Index> followed(Index v, const std::vector<Index>& open) const {
        if (open.size() <= kMostBelow) return open;
        Distances far;
        for (const Index u : open) far.emplace_back(std::round(box_distance(v, u) / kAlike), u);
        std::nth_element(far.begin(), far.begin() + kMostBelow, far.end());
        std::vector<Index> out;
        for (std::size_t i = 0; i < kMostBelow; ++i) out.push_back(far[i].second);
        return out;
    }

    // Adds the pairs of one part. Regions below a hanging one are left out if another lower region follows them, or if
    // they are below the last layer with a hanging region, which follows them.
    void add_pairs(const std::vector<Index>& member, std::vector<Pair>& out) const {
        std::size_t begin = 0; // of the members that the next hanging region may have to follow
        for (std::size_t i = 0, j = 0; i < member.size(); i = j) {
            const Index layer = g.node[member[i]].layer;
            std::vector<Index> hanging, open;
            for (j = i; j < member.size() && g.node[member[j]].layer == layer; ++j)
                if (hangs(member[j])) hanging.push_back(member[j]);
            if (hanging.empty()) continue;
            for (std::size_t k = begin; k < i; ++k)
                if (covered[member[k]] >= layer) open.push_back(member[k]);
            for (const Index v : hanging)
                for (const Index u : followed(v, open)) out.emplace_back(u, v);
            begin = i;
        }
    }
};

} // namespace

std::vector<Pair> below_hanging(const Graph& g, const std::vector<Outline>& outlines) {
    std::vector<Pair> out;
    if (g.size() == 0) return out;
    SupportedParts parts(g, outlines);
    parts.join_floating();
    std::vector<Index> number;
    std::vector<std::vector<Index>> member(parts.set.number(number));
    for (Index v = 0; v < g.size(); ++v) member[number[v]].push_back(v);
    for (const auto& m : member) parts.add_pairs(m, out);
    return out;
}

} // namespace filum::sequence
