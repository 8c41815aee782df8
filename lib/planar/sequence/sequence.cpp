#include "sequence/sequence.hpp"

#include "base/error.hpp"
#include "sequence/arrange.hpp"
#include "sequence/brims.hpp"
#include "sequence/canon.hpp"
#include "sequence/collision.hpp"
#include "sequence/hanging.hpp"
#include "sequence/plan.hpp"

namespace filum::sequence {

namespace {

void add_strokes(SequenceResult& to, const Order& order, std::span<const polygon::Region> regions) {
    std::uint32_t stroke = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool on = i > 0 && continues(to.graph, order[i - 1], order[i]);
        if (i > 0 && !on) ++stroke;
        to.stroke.push_back(stroke);
        const bool beside = on && regions[order[i]].layer == regions[order[i - 1]].layer;
        to.join.push_back(beside ? Join::beside : on ? Join::vertical : Join::start);
    }
}

Facts facts(const SequenceResult& r, const Plan& p, const Columns& c, std::size_t collisions, std::uint64_t assumed,
            std::size_t brims) {
    Facts out;
    const auto add = [&](const std::string& name, double value, const char* unit) {
        out.push_back({"", name, value, unit});
    };
    const double strokes = p.cost.strokes;
    add("regions", r.graph.size(), "");
    add("columns", static_cast<double>(c.member.size()), "");
    add("collisions", static_cast<double>(collisions), "");
    if (assumed > 0) add("collisions-assumed", static_cast<double>(assumed), "");
    add("layer-floor", static_cast<double>(r.graph.size() - brims) - r.graph.node.back().layer, "strokes");
    add("path-cover", p.path_cover, "strokes");
    if (p.relaxation > 0) add("relaxation-bound", p.relaxation, "strokes");
    add("lower-bound", p.bound, "strokes");
    add("planned-strokes", strokes, "strokes");
    add("gap", 100 * (strokes - p.bound) / strokes, "%");
    const auto counts = tally(r.ends);
    const std::size_t several = tools(r.graph).size();
    for (std::size_t i = 0; i < kCauses; ++i)
        if (several > 1 || static_cast<Cause>(i) != Cause::idle)
            add("ends-" + std::string(name(static_cast<Cause>(i))), counts[i], "strokes");
    add("steps", static_cast<double>(p.steps) / 1e6, "million");
    add("search-complete", p.complete ? 1 : 0, "");
    if (several < 2) return out;
    add("tools", static_cast<double>(several), "");
    add("tool-changes", p.cost.changes, "");
    add("tool-changes-bound", p.change_bound, "");
    return out;
}

// Per region the one whose hole holds it.
std::vector<Index> surrounding(std::span<const polygon::Region> regions) {
    std::vector<Index> out;
    for (const auto& r : regions) {
        const bool known = r.parent >= 0 && r.parent < static_cast<std::int64_t>(regions.size()) && r.parent != r.id &&
                           regions[static_cast<std::size_t>(r.parent)].area > r.area;
        out.push_back(known ? static_cast<Index>(r.parent) : kNone);
    }
    return out;
}

std::string bound_by(const Plan& p) {
    if (p.bound == p.path_cover) return "path-cover";
    return p.bound == p.relaxation ? "relaxation-bound" : "search";
}

} // namespace

SequenceResult sequence(std::vector<polygon::Region> regions, const Options& options) {
    SequenceResult out;
    out.graph = support_graph(regions);
    Graph& g = out.graph;
    if (g.size() == 0) return out;
    const Columns c = columns(g, colours(g));
    const Arcs support = g.after;
    if (auto far = carried_from_afar(regions); !far.empty()) add_precedence(g, std::move(far));
    const std::vector<Pair> rims = brims(regions);
    const std::vector<Index> first = skirts(regions);
    std::vector<Outline> outlines;
    std::vector<Pair> hits;
    DistanceWork work;
    if (!options.by_layers) { // layer order keeps the following precedences anyway
        for (auto& r : regions) outlines.push_back(outline(std::move(r.loops)));
        add_precedence(g, below_hanging(g, outlines));
        hits = collisions(g, c, outlines, options.heads, work);
        add_precedence(g, hits);
        hold_together(rims, g);
    }
    Plan p = options.by_layers ? layer_plan(g) : plan(g, c, options.budget, options.first);
    if (options.by_layers && options.layers) {
        p.order = options.layers(regions);
        p.cost = cost(g, p.order);
    }
    const std::vector<Index> around = surrounding(regions);
    if (options.from_inside) p.order = from_inside(g, std::move(p.order), around);
    begin_with(rims, g, p);
    put_first(first, g, p);
    check(g, p.order);
    if (p.cost.strokes < p.bound) throw Error(Exit::failure, "internal error: fewer strokes than the lower bound");
    if (p.cost.changes < p.change_bound)
        throw Error(Exit::failure, "internal error: fewer tool changes than the lower bound");
    add_strokes(out, p.order, regions);
    out.ends = ends(g, p.order, support, outlines, options.heads);
    out.facts = facts(out, p, c, hits.size(), work.assumed, rims.size());
    if (options.from_inside)
        out.facts.push_back({"", "outer-first", static_cast<double>(outer_first(g, p.order, around)), "strokes"});
    out.bound_by = bound_by(p);
    out.order = std::move(p.order);
    return out;
}

} // namespace filum::sequence
