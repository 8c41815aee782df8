#include "sequence/plan.hpp"

#include "sequence/arrange.hpp"
#include "sequence/canon.hpp"
#include "sequence/climb.hpp"
#include "sequence/matching.hpp"
#include "sequence/mend.hpp"
#include "sequence/phases.hpp"
#include "sequence/relaxation.hpp"
#include "sequence/search.hpp"

#include <algorithm>

namespace filum::sequence {

namespace {

constexpr double kBaseWeight = 0.02; // weight of a printed region without any neighbours
constexpr double kNearShare = 0.1;   // share of the weights by neighbours if the bound has priced the regions
constexpr std::uint64_t kMostKept = 16'000'000; // regions in all stored strokes of a search, which bounds its memory

struct Planner {
    const Graph& g;
    const Columns& columns;
    Plan best;

    void offer(Order o) {
        if (best.change_bound > 0) o = by_tools(g, std::move(o));
        const Cost c = cost(g, o);
        if (best.order.empty() || less(c, best.cost, Priority::strokes)) {
            best.order = std::move(o);
            best.cost = c;
        }
    }
    void prove(Index strokes) { best.bound = std::max(best.bound, strokes); }
    [[nodiscard]] bool proven() const {
        return best.cost.strokes == best.bound && (best.cost.changes == best.change_bound || best.complete);
    }

    // Searches of increasing width with each of the weights, until one proves its order optimal or the budget is used
    // up.
    void widen(const std::vector<std::vector<double>>& weights, std::uint64_t budget) {
        std::uint64_t left = budget;
        if (columns.member.size() * std::uint64_t{best.bound} > budget)
            return; // a single state per stroke takes as much
        for (std::size_t width = 1; width * g.size() <= kMostKept || width == 1;) {
            std::uint64_t most = 1;
            for (const auto& weight : weights) {
                SearchResult f = search(g, columns, weight, width, left);
                best.steps += f.work;
                if (f.order.empty()) return;
                offer(f.order);
                if (f.optimal) {
                    best.complete = true;
                    prove(best.cost.strokes);
                }
                if (proven()) return;
                f.work += mend(std::move(f.order), f.work / 4);
                left -= std::min(left, f.work);
                most = std::max(most, f.work);
                if (proven()) return;
            }
            std::size_t factor = 8; // work grows with the width
            while (factor > 1 && most * weights.size() * factor > left) factor /= 2;
            if (factor == 1) return;
            width *= factor;
        }
    }

    // Improves the order and keeps it if it is better; returns the steps taken.
    std::uint64_t mend(Order order, std::uint64_t budget) {
        std::uint64_t steps = 0;
        sequence::mend(g, order, best.bound, budget, steps);
        offer(std::move(order));
        best.steps += steps;
        return steps;
    }

    void tighten(Relaxation& r, std::uint64_t budget) {
        if (proven() || best.cost.strokes == best.bound) return;
        const std::uint64_t before = r.work();
        best.relaxation = r.tighten(best.cost.strokes, budget);
        best.steps += r.work() - before;
        prove(best.relaxation);
    }
};

} // namespace

Plan layer_plan(const Graph& g) {
    Plan p;
    p.order = layer_order(g);
    p.cost = cost(g, p.order);
    p.bound = p.path_cover = path_cover(g);
    p.change_bound = least_changes(g);
    return p;
}

namespace {

Plan plan_part(const Graph& g, const Columns& columns, std::uint64_t budget) {
    Planner p{g, columns, layer_plan(g)};
    for (const StartRule c : {StartRule::longest, StartRule::lowest, StartRule::latest})
        if (!p.proven()) p.offer(climb(g, c));
    if (p.best.change_bound > 0) {
        p.offer(p.best.order); // in the best order of tools
        for (const KeepTool keep : {KeepTool::to_the_end, KeepTool::always})
            for (const StartRule c : {StartRule::longest, StartRule::lowest, StartRule::latest})
                if (!p.proven()) p.offer(climb(g, c, keep));
    }
    if (p.proven()) return std::move(p.best);
    Relaxation r(g, columns);
    p.tighten(r, budget / 10);
    const auto near = weights(g, columns, kBaseWeight);
    auto priced = r.density();
    for (Index v = 0; v < g.size(); ++v) priced[v] += kNearShare * near[v];
    if (!p.proven()) p.widen({near, priced}, budget / 10 * 4);
    if (!p.proven()) p.mend(p.best.order, budget / 10);
    p.tighten(r, budget - std::min(budget, p.best.steps));
    return std::move(p.best);
}

Plan plan_parts(const Graph& g, const Columns& columns, std::uint64_t budget) {
    auto all = parts(g, columns);
    std::stable_sort(all.begin(), all.end(),
                     [](const Part& a, const Part& b) { return a.node.size() < b.node.size(); });
    Plan out;
    std::uint64_t regions = g.size();
    bool searched = false, complete = true, relaxed = false;
    for (const Part& part : all) {
        const auto share = static_cast<std::uint64_t>(static_cast<double>(budget) / static_cast<double>(regions) *
                                                      static_cast<double>(part.node.size()));
        const Plan p = plan_part(part.g, part.columns, std::min(share, budget));
        for (const Index v : p.order) out.order.push_back(part.node[v]);
        out.path_cover += p.path_cover;
        out.relaxation += std::max(p.relaxation, p.path_cover);
        out.bound += p.bound;
        out.steps += p.steps;
        relaxed = relaxed || p.relaxation > 0;
        if (p.complete || p.cost.strokes > p.bound) {
            searched = true;
            complete = complete && p.complete;
        }
        budget -= std::min(budget, p.steps);
        regions -= part.node.size();
    }
    if (!relaxed) out.relaxation = 0;
    out.complete = searched && complete;
    out.order = by_tools(g, std::move(out.order));
    out.cost = cost(g, out.order);
    return out;
}

} // namespace

Plan plan(const Graph& g, const Columns& columns, std::uint64_t budget, Priority first) {
    Plan out = plan_parts(g, columns, budget);
    out.change_bound = least_changes(g);
    if (first == Priority::strokes || out.change_bound == 0 || out.cost.changes == out.change_bound) return out;
    const auto in_phase = [&](const Graph& of_phase, const Columns& its_columns) {
        const std::uint64_t share = budget / g.size() * of_phase.size();
        Plan p = plan_parts(of_phase, its_columns, share);
        out.steps += p.steps;
        return std::move(p.order);
    };
    for (Order& o : phase_orders(g, columns, in_phase)) {
        const Cost c = cost(g, o);
        if (!less(c, out.cost, first)) continue;
        out.order = std::move(o);
        out.cost = c;
    }
    out.complete = false;
    return out;
}

} // namespace filum::sequence
