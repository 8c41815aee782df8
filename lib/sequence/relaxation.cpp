#include "sequence/relaxation.hpp"

#include "sequence/cover.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace filum::sequence {

namespace {

// Columns along the links that are used most: each region goes on to one other, and one other goes on to it.
Columns along_links(const Graph& g, std::span<const double> unused) {
    std::vector<Index> by_use(g.up.size()), from(g.up.size());
    std::iota(by_use.begin(), by_use.end(), 0U);
    std::stable_sort(by_use.begin(), by_use.end(), [&](Index a, Index b) { return unused[a] < unused[b]; });
    for (Index u = 0; u < g.size(); ++u)
        for (Index a = g.up.start[u]; a < g.up.start[u + 1]; ++a) from[a] = u;
    std::vector<Index> above(g.size(), kNone), below(g.size(), kNone);
    for (const Index a : by_use)
        if (const Index u = from[a], v = g.up.to[a]; above[u] == kNone && below[v] == kNone) above[u] = v, below[v] = u;
    Columns out;
    out.of.resize(g.size());
    for (Index v = 0; v < g.size(); ++v) {
        if (below[v] == kNone) out.member.emplace_back();
        out.of[v] = below[v] == kNone ? static_cast<Index>(out.member.size() - 1) : out.of[below[v]];
        out.member[out.of[v]].push_back(v);
    }
    return out;
}

} // namespace

struct Relaxation::State {
    const Graph& g;
    Columns columns;
    std::optional<Cuts> cuts; // of `columns`
    Cover cover;
    Index bound = 0;
    bool done = false;        // no cut is left
    std::uint64_t before = 0; // work of cuts of earlier columns

    State(const Graph& graph, const Columns& c, std::uint64_t budget) : g(graph), columns(c), cover(graph.up.size()) {
        cuts.emplace(g, columns, budget);
        cover.add(cuts->degrees());
    }
    [[nodiscard]] std::uint64_t work() const { return before + cuts->work() + cover.work(); }

    // Adds violated cuts; where there are none, those of columns as the solution climbs them.
    void cut(std::uint64_t budget) {
        auto more = cuts->violated(cover.unused());
        if (more.empty()) {
            before += cuts->work();
            columns = along_links(g, cover.unused());
            cuts.emplace(g, columns, budget);
            more = cuts->violated(cover.unused());
        }
        done = more.empty();
        cover.add(std::move(more));
    }
};

Relaxation::Relaxation(const Graph& g, const Columns& columns, std::uint64_t budget)
    : state_(std::make_unique<State>(g, columns, budget)) {}
Relaxation::~Relaxation() = default;

std::uint64_t Relaxation::work() const { return state_->work(); }

std::vector<double> Relaxation::density() const {
    const Graph& g = state_->g;
    const auto of_link = state_->cover.density();
    std::vector<double> out(g.size(), 0);
    for (Index u = 0; u < g.size(); ++u)
        for (Index a = g.up.start[u]; a < g.up.start[u + 1]; ++a)
            out[u] += of_link[a] / 2, out[g.up.to[a]] += of_link[a] / 2;
    return out;
}

Index Relaxation::tighten(Index target, std::uint64_t budget) {
    State& s = *state_;
    const auto links = static_cast<Index>(s.g.up.size());
    const std::uint64_t limit = s.work() + budget;
    while (!s.done && s.bound < target && s.work() < limit) {
        const bool solved = s.cover.solve(limit - s.work());
        s.bound = std::max(s.bound, s.g.size() - (links - s.cover.proven()));
        if (!solved) break;
        s.cover.forget_slack();
        s.cut(limit > s.work() ? limit - s.work() : 0);
    }
    return s.bound;
}

} // namespace filum::sequence
