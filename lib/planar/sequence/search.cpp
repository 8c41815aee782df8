#include "sequence/search.hpp"

#include "base/mix.hpp"

#include <algorithm>
#include <unordered_map>

namespace filum::sequence {

namespace {

// A stored stroke and its predecessor.
struct StoredStroke {
    Index parent = kNone;
    Index first = 0, count = 0; // its regions in BeamSearch::printed
};

struct BeamState {
    double score = 0;
    std::uint64_t hash = 0;
    Index step = kNone;
    Index tool = kNone; // in use; kNone: the first stroke needs no change
    Index changes = 0;  // of the tool so far
    Index count = 0;    // printed regions
};

struct Candidate {
    BeamState state;
    Index parent = 0;           // index of the state in the level
    Index first = 0, count = 0; // its regions in BeamSearch::tried
};

struct BeamSearch {
    const Graph& g;
    const Columns& columns;
    std::span<const double> weight;
    std::size_t k;
    std::uint64_t hashed;
    bool several;             // tools
    std::vector<Index> place; // of each region in its column
    std::uint64_t work = 0;

    std::vector<StoredStroke> steps;
    std::vector<Index> printed;
    std::vector<BeamState> level;
    std::vector<Index> heights; // of the level's states, k each
    std::vector<Candidate> candidates;
    std::vector<Index> tried;

    std::vector<Index> now; // heights while a stroke is tried
    std::vector<Index> path;
    bool reached_top = false; // a candidate of this state ends at a top, and is the only one that counts

    BeamSearch(const Graph& graph, const Columns& c, std::span<const double> w, std::uint64_t bits)
        : g(graph), columns(c), weight(w), k(c.member.size()), hashed(bits), several(tools(graph).size() > 1),
          place(graph.size()) {
        for (const auto& member : c.member)
            for (std::size_t i = 0; i < member.size(); ++i) place[member[i]] = static_cast<Index>(i);
        level.emplace_back();
        if (!several) level.back().tool = g.node[0].tool;
        heights.assign(k, 0);
    }

    bool ready(Index v) {
        const auto before = g.before[v];
        for (const Index p : before) {
            ++work;
            if (now[columns.of[p]] <= place[p]) return false;
        }
        return true;
    }

    // Adds every stroke that begins with `path` and ends where nothing more is ready.
    void extend(const BeamState& from, Index parent) {
        const Index u = path.back();
        bool ended = true;
        for (const Index v : g.up[u]) {
            if (!ready(v)) continue;
            ended = false;
            path.push_back(v);
            now[columns.of[v]] = place[v] + 1;
            extend(from, parent);
            if (reached_top) return;
            now[columns.of[v]] = place[v];
            path.pop_back();
        }
        if (ended) propose(from, parent);
    }

    void propose(const BeamState& from, Index parent) {
        const Index tool = g.node[path.front()].tool;
        if (g.up[path.back()].empty() && tool == from.tool) {
            while (!candidates.empty() && candidates.back().parent == parent) candidates.pop_back();
            reached_top = true;
        }
        Candidate c{from, parent, static_cast<Index>(tried.size()), static_cast<Index>(path.size())};
        if (from.tool != kNone && tool != from.tool) ++c.state.changes;
        c.state.tool = tool;
        c.state.count += c.count;
        for (const Index v : path) {
            c.state.score += weight[v];
            c.state.hash ^= mixed(v + kMixStep) & hashed;
        }
        tried.insert(tried.end(), path.begin(), path.end());
        candidates.push_back(c);
    }

    void expand(Index s) {
        reached_top = false;
        const auto own = heights.begin() + static_cast<long>(s * k);
        now.assign(own, own + static_cast<long>(k)); // restored after every stroke that is tried
        for (Index c = 0; c < k && !reached_top; ++c) {
            if (now[c] == columns.member[c].size()) continue;
            const Index v = columns.member[c][now[c]];
            ++work;
            if (!ready(v)) continue;
            path.assign(1, v);
            ++now[c];
            extend(level[s], s);
            --now[c];
        }
    }

    // Whether an order from state `a` changes the tool no more often than the same order from state `b`.
    [[nodiscard]] static bool no_more_changes(const BeamState& a, const BeamState& b) {
        return a.changes + (a.tool == b.tool ? 0 : 1) <= b.changes;
    }

    // Whether the state with the heights `h` is contained in one of the first kept ones, which changes the tool no more
    // often.
    [[nodiscard]] bool below_another(const BeamState& state, const std::vector<Index>& h,
                                     const std::vector<BeamState>& next, const std::vector<Index>& kept) const {
        constexpr std::size_t kCompared = 32;
        for (std::size_t i = 0; i < std::min(kCompared, kept.size() / k); ++i)
            if (no_more_changes(next[i], state) &&
                std::equal(h.begin(), h.end(), kept.begin() + static_cast<long>(i * k), std::less_equal<>()))
                return true;
        return false;
    }

    // If everything is printed in some candidate, keeps only the one of these with the fewest changes of the tool.
    void keep_finished() {
        const Candidate* best = nullptr;
        for (const Candidate& c : candidates)
            if (c.state.count == g.size() && (best == nullptr || c.state.changes < best->state.changes)) best = &c;
        if (best != nullptr) candidates = {Candidate(*best)};
    }

    // Selects the next level from the candidates; true if none had to be dropped.
    bool select(std::size_t width) {
        std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
            return a.state.score > b.state.score ||
                   (a.state.score == b.state.score && a.state.changes < b.state.changes);
        });
        if (several) keep_finished();
        std::vector<BeamState> next;
        std::vector<Index> kept;
        std::unordered_multimap<std::uint64_t, Index> seen; // hash to the index of the state in `next`, or kNone
        bool all = true;
        for (const Candidate& c : candidates) {
            now.assign(heights.begin() + static_cast<long>(c.parent * k),
                       heights.begin() + static_cast<long>((c.parent + 1) * k));
            for (Index i = 0; i < c.count; ++i) now[columns.of[tried[c.first + i]]] = place[tried[c.first + i]] + 1;
            const auto alike = seen.equal_range(c.state.hash);
            const bool before = std::any_of(alike.first, alike.second, [&](const auto& s) {
                return s.second != kNone && no_more_changes(next[s.second], c.state) &&
                       std::equal(now.begin(), now.end(), kept.begin() + static_cast<long>(s.second * k));
            });
            if (before || (alike.first != alike.second && below_another(c.state, now, next, kept)))
                continue; // as when it came first
            work += k;
            if (below_another(c.state, now, next, kept)) {
                seen.emplace(c.state.hash, kNone);
                continue;
            }
            if (next.size() == width) {
                all = false;
                break;
            }
            steps.push_back({c.state.step, static_cast<Index>(printed.size()), c.count});
            printed.insert(printed.end(), tried.begin() + c.first, tried.begin() + c.first + c.count);
            next.push_back(c.state);
            next.back().step = static_cast<Index>(steps.size() - 1);
            kept.insert(kept.end(), now.begin(), now.end());
            seen.emplace(c.state.hash, static_cast<Index>(next.size() - 1));
        }
        level = std::move(next);
        heights = std::move(kept);
        return all;
    }

    [[nodiscard]] Order order(Index step) const {
        std::vector<Index> back;
        for (Index s = step; s != kNone; s = steps[s].parent) back.push_back(s);
        Order out;
        for (std::size_t i = back.size(); i-- > 0;)
            for (Index j = 0; j < steps[back[i]].count; ++j) out.push_back(printed[steps[back[i]].first + j]);
        return out;
    }
};

} // namespace

SearchResult search(const Graph& g, const Columns& columns, std::span<const double> weight, std::size_t width,
                    std::uint64_t budget, std::uint64_t hashed) {
    SearchResult out;
    if (g.size() == 0) return {{}, true, 0};
    BeamSearch s(g, columns, weight, hashed);
    bool all = true;
    for (;;) {
        s.candidates.clear();
        s.tried.clear();
        for (Index i = 0; i < s.level.size(); ++i) {
            s.expand(i);
            if (s.work > budget) return {{}, false, s.work};
        }
        if (s.candidates.empty()) break; // everything is printed in every state
        all = s.select(width) && all;
    }
    return {s.order(s.level.front().step), all, s.work};
}

std::vector<double> weights(const Graph& g, const Columns& columns, double base) {
    std::vector<double> out(g.size(), base);
    for (Index v = 0; v < g.size(); ++v) {
        Index least = kNone;
        for (const Index u : g.before[v])
            if (columns.of[u] != columns.of[v]) least = std::min(least, g.node[v].layer - g.node[u].layer);
        for (const Index u : g.after[v])
            if (columns.of[u] != columns.of[v]) least = std::min(least, g.node[u].layer - g.node[v].layer);
        if (least != kNone) out[v] += 1.0 / least;
    }
    return out;
}

} // namespace filum::sequence
