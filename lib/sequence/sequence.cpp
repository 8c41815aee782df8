#include "sequence/sequence.hpp"

#include "sequence/climb.hpp"
#include "sequence/collision.hpp"
#include "sequence/matching.hpp"

namespace filum::sequence {

namespace {

Graph graph(std::vector<polygon::Region>& regions, const Options& options) {
    Graph g = support_graph(regions, options.support_area);
    if (options.order == "layers" || options.head.none) return g;
    const Columns c = columns(regions);
    std::vector<Outline> outlines;
    outlines.reserve(regions.size());
    for (auto& r : regions) outlines.push_back(outline(std::move(r.loops)));
    add_precedence(g, collisions(g, c, outlines, options.head));
    return g;
}

Order best_order(const Graph& g, const Options& options) {
    Order best = layer_order(g);
    if (options.order == "layers") return best;
    for (const Choice c : {Choice::longest, Choice::lowest, Choice::nearest})
        if (Order o = climb(g, c); cost(g, o) < cost(g, best)) best = std::move(o);
    return best;
}

} // namespace

Result sequence(std::vector<polygon::Region> regions, const Options& options) {
    const Graph g = graph(regions, options);
    Result out;
    out.order = best_order(g, options);
    check(g, out.order);
    std::uint32_t stroke = 0;
    for (std::size_t i = 0; i < out.order.size(); ++i) {
        const bool on = i > 0 && continues(g, out.order[i - 1], out.order[i]);
        if (i > 0 && !on) ++stroke;
        out.stroke.push_back(stroke);
        out.join.push_back(on ? Join::vertical : Join::start);
    }
    const double layers = g.size() == 0 ? 0 : g.node.back().layer + 1;
    const double strokes = g.size() == 0 ? 0 : stroke + 1;
    out.facts = {{"", "regions", static_cast<double>(g.size()), ""},
                 {"", "strokes", strokes, "strokes"},
                 {"", "layer-floor", g.size() == 0 ? 0 : g.size() - layers + 1, "strokes"},
                 {"", "path-cover", static_cast<double>(g.size() - matched(maximum_matching(g.up))), "strokes"}};
    return out;
}

} // namespace filum::sequence
