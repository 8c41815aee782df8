#include "sequence/phases.hpp"

#include <algorithm>
#include <utility>

namespace filum::sequence {

namespace {

// The most changes of the tool on a way of precedences that ends at each region, if `first` is in use before it.
std::vector<Index> levels(const Graph& g, Index first) {
    std::vector<Index> out(g.size(), 0);
    for (Index v = 0; v < g.size(); ++v) { // precedences lead to higher numbers
        if (g.before[v].empty()) out[v] = g.node[v].tool == first ? 0 : 1;
        for (const Index u : g.before[v])
            out[v] = std::max(out[v], out[u] + (g.node[u].tool == g.node[v].tool ? 0 : 1));
    }
    return out;
}

// The most changes of the tool on a way of precedences that begins at each region.
std::vector<Index> changes_ahead(const Graph& g) {
    std::vector<Index> out(g.size(), 0);
    for (Index u = g.size(); u-- > 0;)
        for (const Index v : g.after[u]) out[u] = std::max(out[u], out[v] + (g.node[u].tool == g.node[v].tool ? 0 : 1));
    return out;
}

// The state of printing phase by phase.
struct PhaseProgress {
    const Graph& g;
    std::vector<Index> waiting, ahead;
    std::vector<Index> ready;

    explicit PhaseProgress(const Graph& graph) : g(graph), ahead(changes_ahead(graph)) {
        for (Index v = 0; v < g.size(); ++v) {
            waiting.push_back(static_cast<Index>(g.before[v].size()));
            if (waiting.back() == 0) ready.push_back(v);
        }
    }

    // Of the ready regions the one from which most changes follow has the tool that comes next; ties: the lowest.
    [[nodiscard]] Index next_tool() const {
        Index best = ready.front();
        for (const Index v : ready)
            if (ahead[v] > ahead[best] || (ahead[v] == ahead[best] && v < best)) best = v;
        return g.node[best].tool;
    }

    // Prints all that `tool` can, and sets the phase of these regions.
    void print(Index tool, Index number, std::vector<Index>& phase) {
        std::vector<Index> rest;
        for (std::size_t i = 0; i < ready.size(); ++i) { // grows while it is read
            const Index v = ready[i];
            if (g.node[v].tool != tool) {
                rest.push_back(v);
                continue;
            }
            phase[v] = number;
            for (const Index w : g.after[v])
                if (--waiting[w] == 0) ready.push_back(w);
        }
        ready = std::move(rest);
    }
};

// The regions with phase `number` as a graph of their own; node i is `member[i]`.
Graph part_of(const Graph& g, const std::vector<Index>& member, const std::vector<Index>& place) {
    Graph out;
    const auto copy = [&](const Arcs& from) {
        Arcs to;
        for (const Index v : member) {
            for (const Index w : from[v])
                if (place[w] != kNone && member[place[w]] == w) to.to.push_back(place[w]);
            to.start.push_back(static_cast<Index>(to.to.size()));
        }
        return to;
    };
    for (const Index v : member) out.node.push_back(g.node[v]);
    out.up = copy(g.up);
    out.down = copy(g.down);
    out.after = copy(g.after);
    out.before = copy(g.before);
    return out;
}

Columns columns_of(const Columns& columns, const std::vector<Index>& member) {
    Columns out;
    std::vector<Index> number(columns.member.size(), kNone);
    for (Index i = 0; i < member.size(); ++i) {
        Index& c = number[columns.of[member[i]]];
        if (c == kNone) {
            c = static_cast<Index>(out.member.size());
            out.member.emplace_back();
        }
        out.member[c].push_back(i);
        out.of.push_back(c);
    }
    return out;
}

// The order in which each region is printed in its phase.
Order in_phases(const Graph& g, const Columns& columns, const std::vector<Index>& phase, std::size_t count,
                const std::function<Order(const Graph&, const Columns&)>& in_phase) {
    std::vector<std::vector<Index>> member(count);
    for (Index v = 0; v < g.size(); ++v) member[phase[v]].push_back(v);
    Order out;
    std::vector<Index> place(g.size(), kNone);
    for (const auto& m : member) {
        if (m.empty()) continue;
        for (Index i = 0; i < m.size(); ++i) place[m[i]] = i;
        for (const Index i : in_phase(part_of(g, m, place), columns_of(columns, m))) out.push_back(m[i]);
        for (const Index v : m) place[v] = kNone;
    }
    return out;
}

// Puts off regions that begin a run of links in their phase, together with the run, to the phase in which the next
// region above them is printed, if they can wait. That saves a stroke and costs none.
std::vector<Index> put_off(const Graph& g, const Phases& p) {
    std::vector<Index> phase = p.earliest;
    for (Index v = g.size(); v-- > 0;) {
        Index to = kNone; // the first later phase in which a region above is printed
        for (const Index w : g.up[v]) {
            if (phase[w] == phase[v]) to = phase[v];
            if (phase[w] > phase[v] && (to == kNone || phase[w] < to)) to = phase[w];
        }
        const bool begins =
            std::none_of(g.down[v].begin(), g.down[v].end(), [&](Index u) { return phase[u] == phase[v]; });
        if (to == kNone || to == phase[v] || !begins) continue;
        Index least = p.latest[v];
        for (const Index w : g.after[v]) least = std::min(least, phase[w]);
        if (to <= least) phase[v] = to;
    }
    return phase;
}

} // namespace

Index least_changes(const Graph& g) {
    const std::vector<Index> all = tools(g);
    if (all.size() < 2) return 0;
    Index best = kNone;
    for (const Index first : all) {
        const auto level = levels(g, first);
        best = std::min(best, *std::max_element(level.begin(), level.end()));
    }
    return std::max(best, static_cast<Index>(all.size()) - 1);
}

Phases phases(const Graph& g, Index first_tool) {
    Phases out{{}, std::vector<Index>(g.size(), 0), {}};
    PhaseProgress s(g);
    for (Index tool = first_tool; !s.ready.empty(); tool = s.next_tool()) {
        s.print(tool, static_cast<Index>(out.tool.size()), out.earliest);
        out.tool.push_back(tool);
        if (s.ready.empty()) break;
    }
    const auto last = static_cast<Index>(out.tool.size());
    out.latest.assign(g.size(), 0);
    for (Index v = g.size(); v-- > 0;) {
        Index most = last - 1;
        for (const Index w : g.after[v]) most = std::min(most, out.latest[w]);
        while (most > out.earliest[v] && out.tool[most] != g.node[v].tool) --most;
        out.latest[v] = most;
    }
    return out;
}

std::vector<Order> phase_orders(const Graph& g, const Columns& columns,
                                const std::function<Order(const Graph&, const Columns&)>& in_phase) {
    std::vector<Order> out;
    for (const Index first : tools(g)) {
        bool can = false;
        for (Index v = 0; v < g.size(); ++v) can = can || (g.before[v].empty() && g.node[v].tool == first);
        if (!can) continue;
        const Phases p = phases(g, first);
        for (const auto& phase : {p.earliest, p.latest, put_off(g, p)})
            out.push_back(in_phases(g, columns, phase, p.tool.size(), in_phase));
    }
    return out;
}

} // namespace filum::sequence
