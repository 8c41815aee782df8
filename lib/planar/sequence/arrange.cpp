#include "sequence/arrange.hpp"

#include "geom/nearest_points.hpp"

#include <algorithm>
#include <numeric>
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

// Where each stroke begins: the centre of its first region.
std::vector<geom::Vec2> starts(const Graph& g, const Order& order, const Strokes& s) {
    std::vector<geom::Vec2> out;
    for (std::size_t i = 0; i + 1 < s.first.size(); ++i) out.push_back(g.node[order[s.first[i]]].centre);
    return out;
}

// Lists the strokes of `order` one after the other, each after all that it must follow. `ready` holds the strokes that
// may come next: put(stroke) adds one, and take(from) takes one out; `from` is the centre of the last region, if there
// is one. Fewer regions than `order` has if `take` returns nothing.
template <class Ready>
Order listed(const Graph& g, const Order& order, const Strokes& s, StrokePrecedence p, Ready ready) {
    for (Index i = 0; i < p.waiting.size(); ++i)
        if (p.waiting[i] == 0) ready.put(i);
    Order out;
    while (out.size() < order.size()) {
        const std::optional<Index> i =
            ready.take(out.empty() ? std::nullopt : std::optional<geom::Vec2>(g.node[out.back()].centre));
        if (!i) return out;
        out.insert(out.end(), order.begin() + s.first[*i], order.begin() + s.first[*i + 1]);
        for (const Index j : p.after[*i])
            if (--p.waiting[j] == 0) ready.put(j);
    }
    return out;
}

// Ready strokes; the nearest comes next. Ties, and the first one of all: the lowest id of the first region.
class NearestReady {
  public:
    NearestReady(const Graph& g, const Order& order, const Strokes& s) : by_id_(s.first.size() - 1), rank_(by_id_) {
        std::iota(by_id_.begin(), by_id_.end(), 0);
        std::sort(by_id_.begin(), by_id_.end(),
                  [&](Index a, Index b) { return order[s.first[a]] < order[s.first[b]]; });
        const std::vector<geom::Vec2> start = starts(g, order, s);
        std::vector<geom::Vec2> sorted;
        for (Index i = 0; i < by_id_.size(); ++i) {
            rank_[by_id_[i]] = i;
            sorted.push_back(start[by_id_[i]]);
        }
        points_ = geom::NearestPoints(std::move(sorted));
    }
    void put(Index stroke) {
        points_.insert(rank_[stroke]);
        first_ = std::min(first_, rank_[stroke]);
    }
    std::optional<Index> take(std::optional<geom::Vec2> from) {
        const Index next = from ? points_.nearest(*from).value() : first_;
        points_.remove(next);
        return by_id_[next];
    }

  private:
    std::vector<Index> by_id_, rank_; // strokes in order of the id of their first region; the place of each there
    geom::NearestPoints<geom::Vec2> points_{{}}; // by rank
    Index first_ = kNone;                        // the lowest rank that has been ready
};

} // namespace

Order arranged(const Graph& g, Order order) {
    if (order.empty()) return order;
    const Strokes s = strokes_of(g, order);
    Order out = listed(g, order, s, precedence(g, s), NearestReady(g, order, s));
    return cost(g, out) < cost(g, order) ? out : order;
}

namespace {

// The tool of each stroke, and how often it changes.
struct StrokeTools {
    std::vector<Index> of;      // per stroke: the index of its tool among all, ascending
    std::vector<Index> changes; // per stroke: the most changes of the tool on a way of precedences from it
};

// Strokes are numbered as in `order`, which keeps the precedences, so later ones have higher numbers.
StrokeTools stroke_tools(const Graph& g, const Order& order, const Strokes& s, const StrokePrecedence& p,
                         std::span<const Index> all) {
    StrokeTools out;
    for (std::size_t i = 0; i + 1 < s.first.size(); ++i) {
        const Index number = g.node[order[s.first[i]]].tool;
        out.of.push_back(static_cast<Index>(std::lower_bound(all.begin(), all.end(), number) - all.begin()));
    }
    out.changes.assign(out.of.size(), 0);
    for (std::size_t i = out.of.size(); i-- > 0;)
        for (const Index j : p.after[static_cast<Index>(i)])
            out.changes[i] = std::max(out.changes[i], out.changes[j] + (out.of[i] != out.of[j] ? 1 : 0));
    return out;
}

// Ready strokes; those of the present tool come first, always the nearest one.
class ToolReady {
  public:
    // `first`: the index of the first tool.
    ToolReady(const StrokeTools& tools, std::size_t count, Index first, const std::vector<geom::Vec2>& start)
        : tools_(tools), now_(first), ready_(count), near_(count, geom::NearestPoints<geom::Vec2>(start)) {}
    void put(Index stroke) {
        ready_[tools_.of[stroke]].insert(stroke);
        near_[tools_.of[stroke]].insert(stroke);
    }
    std::optional<Index> take(std::optional<geom::Vec2> from) {
        if (ready_[now_].empty()) now_ = next_tool();
        const Index stroke = from ? near_[now_].nearest(*from).value() : *ready_[now_].begin();
        ready_[now_].erase(stroke);
        near_[now_].remove(stroke);
        return stroke;
    }

  private:
    // Of the ready strokes the one from which most changes follow has the tool that comes next. Ties: the lower number.
    [[nodiscard]] Index next_tool() const {
        Index best = kNone;
        for (const auto& set : ready_)
            for (const Index i : set)
                if (best == kNone || tools_.changes[i] > tools_.changes[best] ||
                    (tools_.changes[i] == tools_.changes[best] && i < best))
                    best = i;
        return tools_.of[best];
    }

    const StrokeTools& tools_;
    Index now_;                                         // the index of the present tool
    std::vector<std::set<Index>> ready_;                // per tool
    std::vector<geom::NearestPoints<geom::Vec2>> near_; // the same, by place
};

} // namespace

Order by_tools(const Graph& g, Order order) {
    const std::vector<Index> all = tools(g);
    if (all.size() < 2) return arranged(g, std::move(order));
    const Strokes s = strokes_of(g, order);
    const StrokePrecedence p = precedence(g, s);
    const StrokeTools t = stroke_tools(g, order, s, p, all);
    const std::vector<geom::Vec2> start = starts(g, order, s);
    Order best;
    Cost least;
    for (Index first = 0; first < all.size(); ++first) {
        bool ready = false;
        for (Index i = 0; i < p.waiting.size(); ++i) ready = ready || (p.waiting[i] == 0 && t.of[i] == first);
        if (!ready) continue;
        Order out = listed(g, order, s, p, ToolReady(t, all.size(), first, start));
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

// Ready strokes; the nearest comes next. Those that surround a ready one are held back. Strokes that surround
// each other on different layers are all held back; then the first one of them comes next.
class InnerReady {
  public:
    // `outer`: of each stroke those that surround it.
    InnerReady(const Arcs& outer, const std::vector<geom::Vec2>& start)
        : outer_(outer), start_(start.front()), open_(start), within_(start.size(), 0), ready_(start.size(), 0) {}
    void put(Index i) {
        ready_[i] = 1;
        if (within_[i] == 0) open_.insert(i);
        for (const Index o : outer_[i])
            if (within_[o]++ == 0 && ready_[o] != 0) open_.remove(o);
    }
    std::optional<Index> take(std::optional<geom::Vec2> from) {
        const Index i = !open_.empty() ? open_.nearest(from.value_or(start_)).value() : first();
        if (i == ready_.size()) return std::nullopt;
        ready_[i] = 0;
        if (within_[i] == 0) open_.remove(i);
        for (const Index o : outer_[i])
            if (--within_[o] == 0 && ready_[o] != 0) open_.insert(o);
        return i;
    }

  private:
    [[nodiscard]] Index first() const {
        return static_cast<Index>(std::find(ready_.begin(), ready_.end(), 1) - ready_.begin());
    }

    const Arcs& outer_;
    geom::Vec2 start_;
    geom::NearestPoints<geom::Vec2> open_; // those that are not held back
    std::vector<Index> within_;            // per stroke: the number of ready strokes within
    std::vector<char> ready_;
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

// The strokes of `order`, which need not be in an order that precedences allow; fewer regions if no order of them is
// allowed.
Order listed_from_inside(const Graph& g, const Order& order, std::span<const Index> around) {
    const Strokes s = strokes_of(g, order);
    const Arcs outer = reversed(arcs(s.first.size() - 1, nested(g, s, around)));
    return listed(g, order, s, precedence(g, s), InnerReady(outer, starts(g, order, s)));
}

} // namespace

Order from_inside(const Graph& g, Order order, std::span<const Index> around) {
    if (order.empty() || tools(g).size() > 1 || nested(g, strokes_of(g, order), around).empty()) return order;
    for (const Order& tried : {inwards(g, order, around), order}) {
        Order out = listed_from_inside(g, tried, around);
        if (out.size() == order.size() && cost(g, out).strokes <= cost(g, order).strokes) return out;
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
