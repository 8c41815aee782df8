#include "sequence/arrange.hpp"

#include "geom/nearest_points.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace filum::sequence {

namespace {

// The strokes of an order: stroke s consists of order[first[s]] to order[first[s + 1] - 1].
struct Strokes {
    std::vector<Index> first, of; // the stroke of each node
};

Strokes strokes_of(const Graph& g, std::span<const Index> order) {
    Strokes out;
    out.of.resize(g.size());
    for (Index i = 0; i < order.size(); ++i) {
        if (i == 0 || !continues(g, order[i - 1], order[i])) out.first.push_back(i);
        out.of[order[i]] = static_cast<Index>(out.first.size() - 1);
    }
    out.first.push_back(static_cast<Index>(order.size()));
    return out;
}

// The strokes that must follow each stroke, and the number of strokes that each follows.
struct StrokePrecedence {
    Arcs after;
    std::vector<Index> waiting;
};

StrokePrecedence precedence(const Graph& g, const Strokes& s) {
    std::vector<Pair> pairs;
    for (Index u = 0; u < g.size(); ++u)
        for (const Index v : g.after[u])
            if (s.of[u] != s.of[v]) pairs.emplace_back(s.of[u], s.of[v]);
    StrokePrecedence out{arcs(s.first.size() - 1, std::move(pairs)), {}};
    out.waiting.assign(s.first.size() - 1, 0);
    for (const Index v : out.after.to) ++out.waiting[v];
    return out;
}

} // namespace

Order arranged(const Graph& g, Order order) {
    if (order.empty()) return order;
    const Strokes s = strokes_of(g, order);
    StrokePrecedence p = precedence(g, s);
    const auto n = static_cast<Index>(p.waiting.size());
    std::vector<Index> by_id(n), number(n); // so that ties go to the lower id of the first region
    for (Index i = 0; i < n; ++i) by_id[i] = i;
    std::sort(by_id.begin(), by_id.end(), [&](Index a, Index b) { return order[s.first[a]] < order[s.first[b]]; });
    std::vector<geom::Vec2> start;
    for (Index i = 0; i < n; ++i) {
        number[by_id[i]] = i;
        start.push_back(g.node[order[s.first[by_id[i]]]].centre);
    }
    geom::NearestPoints ready(start);
    for (Index i = 0; i < n; ++i)
        if (p.waiting[i] == 0) ready.insert(number[i]);
    Order out;
    const auto first = std::find_if(by_id.begin(), by_id.end(), [&](Index i) { return p.waiting[i] == 0; });
    for (auto next = number[*first];; next = *ready.nearest(g.node[out.back()].centre)) {
        const Index i = by_id[next];
        ready.remove(next);
        out.insert(out.end(), order.begin() + s.first[i], order.begin() + s.first[i + 1]);
        for (const Index j : p.after[i])
            if (--p.waiting[j] == 0) ready.insert(number[j]);
        if (ready.empty()) break;
    }
    return cost(g, out) < cost(g, order) ? out : order;
}

namespace {

// The strokes of an order as `by_tools` prints them.
struct ToolOrder {
    const Graph& g;
    const Order& order;
    const Strokes& s;
    const StrokePrecedence& p;
    std::vector<Index> tools;   // ascending
    std::vector<Index> changes; // per stroke: the most changes of the tool on a way of precedences from it

    // The index of the stroke's tool among `tools`.
    [[nodiscard]] Index tool(Index stroke) const {
        const Index number = g.node[order[s.first[stroke]]].tool;
        return static_cast<Index>(std::lower_bound(tools.begin(), tools.end(), number) - tools.begin());
    }

    // Strokes are numbered as in `order`, which keeps the precedences, so later ones have higher numbers.
    void count_changes() {
        const auto n = static_cast<Index>(p.waiting.size());
        changes.assign(n, 0);
        for (Index i = n; i-- > 0;)
            for (const Index j : p.after[i])
                changes[i] = std::max(changes[i], changes[j] + (tool(i) != tool(j) ? 1 : 0));
    }

    // Of the ready strokes the one from which most changes follow has the tool that comes next. Ties: the lower number.
    [[nodiscard]] Index next_tool(const std::vector<std::set<Index>>& ready) const {
        Index best = kNone;
        for (const auto& set : ready)
            for (const Index i : set)
                if (best == kNone || changes[i] > changes[best] || (changes[i] == changes[best] && i < best)) best = i;
        return tool(best);
    }

    // The order that begins with the tool `now`.
    [[nodiscard]] Order from(Index now) const {
        std::vector<Index> waiting = p.waiting;
        std::vector<std::set<Index>> ready(tools.size());
        std::vector<geom::Vec2> start;
        for (Index i = 0; i < waiting.size(); ++i) start.push_back(g.node[order[s.first[i]]].centre);
        std::vector<geom::NearestPoints<geom::Vec2>> near(tools.size(), geom::NearestPoints<geom::Vec2>(start));
        const auto put = [&](Index i) {
            ready[tool(i)].insert(i);
            near[tool(i)].insert(i);
        };
        for (Index i = 0; i < waiting.size(); ++i)
            if (waiting[i] == 0) put(i);
        Order out;
        while (out.size() < order.size()) {
            if (ready[now].empty()) now = next_tool(ready);
            const Index i = out.empty() ? *ready[now].begin() : *near[now].nearest(g.node[out.back()].centre);
            ready[now].erase(i);
            near[now].remove(i);
            out.insert(out.end(), order.begin() + s.first[i], order.begin() + s.first[i + 1]);
            for (const Index j : p.after[i])
                if (--waiting[j] == 0) put(j);
        }
        return out;
    }
};

} // namespace

Order by_tools(const Graph& g, Order order) {
    std::vector<Index> all = tools(g);
    if (all.size() < 2) return arranged(g, std::move(order));
    const Strokes s = strokes_of(g, order);
    const StrokePrecedence p = precedence(g, s);
    ToolOrder t{g, order, s, p, std::move(all), {}};
    t.count_changes();
    Order best;
    Cost least;
    for (Index first = 0; first < t.tools.size(); ++first) {
        bool ready = false;
        for (Index i = 0; i < p.waiting.size(); ++i) ready = ready || (p.waiting[i] == 0 && t.tool(i) == first);
        if (!ready) continue;
        Order out = t.from(first);
        const Cost c = cost(g, out);
        if (!best.empty() && !(c < least)) continue;
        best = std::move(out);
        least = c;
    }
    return least < cost(g, order) ? best : order;
}

namespace {

// Pairs (outer, inner) of strokes: the first surrounds a region of the second.
std::vector<Pair> nested(const Graph& g, const Strokes& s, std::span<const Index> around) {
    std::vector<Pair> out;
    for (Index v = 0; v < g.size(); ++v)
        for (Index u = around[v]; u != kNone; u = around[u])
            if (s.of[u] != s.of[v]) out.emplace_back(s.of[u], s.of[v]);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

// The strokes that are ready. Those that surround a ready one are held back.
struct ReadyStrokes {
    const Arcs& outer; // of each stroke: those that surround it
    geom::NearestPoints<geom::Vec2> open;
    std::vector<Index> within; // per stroke: the number of ready strokes within
    std::vector<char> ready;

    void put(Index i) {
        ready[i] = 1;
        if (within[i] == 0) open.insert(i);
        for (const Index o : outer[i])
            if (within[o]++ == 0 && ready[o] != 0) open.remove(o);
    }
    void take(Index i) {
        ready[i] = 0;
        if (within[i] == 0) open.remove(i);
        for (const Index o : outer[i])
            if (--within[o] == 0 && ready[o] != 0) open.insert(o);
    }
    // The nearest of the strokes that are not held back; the number of strokes if none is ready. Strokes that surround
    // each other on different layers are all held back; then the first one.
    [[nodiscard]] Index next(geom::Vec2 from) const {
        if (!open.empty()) return *open.nearest(from);
        return static_cast<Index>(std::find(ready.begin(), ready.end(), 1) - ready.begin());
    }
};

bool surrounds(Index outer, Index inner, std::span<const Index> around) {
    while (inner != kNone && inner != outer) inner = around[inner];
    return inner == outer;
}

// The same number of strokes that rather go on inwards: where one goes on from u to v, and another one begins with a
// region w that u carries as well and v surrounds, both exchange the rest.
Order inwards(const Graph& g, const Order& order, std::span<const Index> around) {
    const Strokes s = strokes_of(g, order);
    std::vector<Order> strokes;
    std::vector<Index> begins(g.size(), kNone); // per region the stroke that begins with it
    for (std::size_t i = 0; i + 1 < s.first.size(); ++i) {
        begins[order[s.first[i]]] = static_cast<Index>(i);
        strokes.emplace_back(order.begin() + s.first[i], order.begin() + s.first[i + 1]);
    }
    for (Index i = 0; i < strokes.size(); ++i)
        for (std::size_t k = 0; k + 1 < strokes[i].size(); ++k) {
            const Index v = strokes[i][k + 1];
            Index best = kNone;
            for (const Index w : g.up[strokes[i][k]])
                if (w != v && begins[w] != kNone && begins[w] != i && surrounds(best == kNone ? v : best, w, around))
                    best = w;
            if (best == kNone) continue;
            const Index other = begins[best];
            Order rest(strokes[i].begin() + static_cast<std::ptrdiff_t>(k) + 1, strokes[i].end());
            strokes[i].resize(k + 1);
            strokes[i].insert(strokes[i].end(), strokes[other].begin(), strokes[other].end());
            strokes[other] = std::move(rest);
            begins[best] = kNone;
            begins[v] = other;
        }
    Order out;
    for (const Order& stroke : strokes) out.insert(out.end(), stroke.begin(), stroke.end());
    return out;
}

// The strokes of `order`, which need not be in an order that precedences allow; nothing if no order of them is allowed.
std::optional<Order> from_inside_of(const Graph& g, const Order& order, std::span<const Index> around) {
    const Strokes s = strokes_of(g, order);
    StrokePrecedence p = precedence(g, s);
    const auto n = static_cast<Index>(p.waiting.size());
    const Arcs outer = reversed(arcs(n, nested(g, s, around)));
    std::vector<geom::Vec2> start;
    for (Index i = 0; i < n; ++i) start.push_back(g.node[order[s.first[i]]].centre);
    ReadyStrokes ready{outer, geom::NearestPoints(start), std::vector<Index>(n, 0), std::vector<char>(n, 0)};
    for (Index i = 0; i < n; ++i)
        if (p.waiting[i] == 0) ready.put(i);
    Order out;
    geom::Vec2 at = start.front();
    while (out.size() < order.size()) {
        const Index i = ready.next(at);
        if (i == n) return std::nullopt;
        ready.take(i);
        out.insert(out.end(), order.begin() + s.first[i], order.begin() + s.first[i + 1]);
        at = g.node[out.back()].centre;
        for (const Index j : p.after[i])
            if (--p.waiting[j] == 0) ready.put(j);
    }
    return out;
}

} // namespace

Order from_inside(const Graph& g, Order order, std::span<const Index> around) {
    if (order.empty() || tools(g).size() > 1 || nested(g, strokes_of(g, order), around).empty()) return order;
    for (const Order& tried : {inwards(g, order, around), order}) {
        const auto out = from_inside_of(g, tried, around);
        if (out && cost(g, *out).strokes <= cost(g, order).strokes) return *out;
    }
    return order;
}

std::size_t outer_first(const Graph& g, const Order& order, std::span<const Index> around) {
    std::size_t out = 0;
    Index last = kNone;
    for (const auto& [outer, inner] : nested(g, strokes_of(g, order), around)) { // strokes are numbered in their order
        if (outer < inner && outer != last) {
            ++out;
            last = outer;
        }
    }
    return out;
}

} // namespace filum::sequence
