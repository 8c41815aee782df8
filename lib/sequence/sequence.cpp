#include "sequence/sequence.hpp"

#include "base/error.hpp"
#include "sequence/bound.hpp"
#include "sequence/climb.hpp"
#include "sequence/collision.hpp"
#include "sequence/relaxation.hpp"
#include "sequence/search.hpp"
#include "sequence/sun2019_order.hpp"

#include <algorithm>

namespace filum::sequence {

namespace {

constexpr double kBaseWeight = 0.02;            // a printed region counts this much even where nothing is near
constexpr std::uint64_t kMostKept = 16'000'000; // regions in all kept strokes of a search: bounds its memory
constexpr std::uint64_t kSlabShare = 10;        // the slab bound gets this part of the budget

std::vector<Pair> head_collisions(const Graph& g, const Columns& c, std::vector<polygon::Region>& regions,
                                  const machine::Head& head) {
    if (head.none) return {};
    std::vector<Outline> outlines;
    outlines.reserve(regions.size());
    for (auto& r : regions) outlines.push_back(outline(std::move(r.loops)));
    return collisions(g, c, outlines, head);
}

struct Best {
    Order order;
    Cost cost;
    Index bound = 0;

    void offer(const Graph& g, Order o) {
        if (const Cost c = sequence::cost(g, o); order.empty() || c < cost) order = std::move(o), cost = c;
    }
    [[nodiscard]] bool proven() const { return cost.strokes == bound; }
};

// Searches of growing width until one proves its order best or the budget is used up.
void widen(Best& best, const Graph& g, const Columns& columns, std::span<const double> weight, std::uint64_t budget) {
    std::uint64_t left = budget;
    for (std::size_t width = 1; width * g.size() <= kMostKept || width == 1;) {
        Found f = search(g, columns, weight, width, left);
        if (f.order.empty()) return;
        left -= std::min(left, f.work);
        best.offer(g, std::move(f.order));
        if (f.optimal) best.bound = best.cost.strokes;
        if (best.proven()) return;
        std::size_t factor = 8; // work grows with the width
        while (factor > 1 && f.work * factor > left) factor /= 2;
        if (factor == 1) return;
        width *= factor;
    }
}

Best best_order(const Graph& g, const Columns& columns, const std::vector<Pair>& collisions, const Options& options) {
    Best best;
    best.bound = path_cover(g);
    best.offer(g, layer_order(g));
    if (options.by_layers) return best;
    Relaxation relaxation(g, columns, options.budget / kSlabShare);
    if (!collisions.empty()) best.bound = std::max(best.bound, relaxation.tighten(kNone, options.budget / kSlabShare));
    for (const Choice c : {Choice::longest, Choice::lowest, Choice::nearest}) best.offer(g, climb(g, c));
    const auto weight = weights(g, columns, kBaseWeight);
    widen(best, g, columns, weight, options.budget);
    if (!best.proven()) best.bound = std::max(best.bound, relaxation.tighten(best.cost.strokes, options.budget));
    if (!best.proven()) best.bound = std::max(best.bound, slab_bound(g, columns, weight, options.budget / kSlabShare));
    return best;
}

} // namespace

Result sequence(std::vector<polygon::Region> regions, const Options& options) {
    Graph g = support_graph(regions, options.support_area);
    if (g.size() == 0) return {};
    const Columns c = columns(regions);
    std::vector<Pair> hits;
    if (!options.by_layers && !options.sun2019) hits = head_collisions(g, c, regions, options.head);
    add_precedence(g, hits);
    Best best;
    if (options.sun2019)
        best.bound = path_cover(g), best.offer(g, sun2019_order(regions));
    else
        best = best_order(g, c, hits, options);
    check(g, best.order);
    if (best.cost.strokes < best.bound)
        throw Error(Exit::failure, "internal error: fewer strokes than the lower bound");

    Result out;
    std::uint32_t stroke = 0;
    for (std::size_t i = 0; i < best.order.size(); ++i) {
        const bool on = i > 0 && continues(g, best.order[i - 1], best.order[i]);
        if (i > 0 && !on) ++stroke;
        out.stroke.push_back(stroke);
        out.join.push_back(on ? Join::vertical : Join::start);
    }
    const auto fact = [&](const char* name, double value, const char* unit) {
        out.facts.push_back({"", name, value, unit});
    };
    fact("regions", g.size(), "");
    fact("columns", static_cast<double>(c.member.size()), "");
    fact("collisions", static_cast<double>(hits.size()), "");
    fact("layer-floor", g.size() - g.node.back().layer, "strokes");
    fact("path-cover", path_cover(g), "strokes");
    fact("lower-bound", best.bound, "strokes");
    fact("strokes", best.cost.strokes, "strokes");
    out.order = std::move(best.order);
    return out;
}

} // namespace filum::sequence
