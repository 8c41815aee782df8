#include "sequence/relaxation.hpp"

#include "sequence/cover.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace filum::sequence {

struct Relaxation::State {
    const Graph& g;
    Cuts cuts;
    Cover cover;
    Index bound = 0;
    bool done = false;

    State(const Graph& graph, const Columns& columns, std::uint64_t budget)
        : g(graph), cuts(graph, columns, budget), cover(graph.up.size()) {
        cover.add(cuts.degrees());
    }
    [[nodiscard]] std::uint64_t work() const { return cuts.work() + cover.work(); }
};

Relaxation::Relaxation(const Graph& g, const Columns& columns, std::uint64_t budget)
    : state_(std::make_unique<State>(g, columns, budget)) {}
Relaxation::~Relaxation() = default;

std::uint64_t Relaxation::work() const { return state_->work(); }

Index Relaxation::tighten(Index target, std::uint64_t budget) {
    State& s = *state_;
    const auto links = static_cast<Index>(s.g.up.size());
    const std::uint64_t limit = s.work() + budget;
    while (!s.done && s.bound < target && s.work() < limit) {
        const std::uint64_t pivots = (limit - s.work()) / (links + 1) + 1;
        const bool solved = s.cover.solve(static_cast<Index>(std::min<std::uint64_t>(pivots, 1U << 30)));
        s.bound = std::max(s.bound, s.g.size() - (links - s.cover.proven()));
        if (getenv("DBG")) fprintf(stderr, "bound %u work %.1f cover %.1f cuts %.1f solved %d t %.2f\n", s.bound, s.work() / 1e6, s.cover.work() / 1e6, s.cuts.work() / 1e6, solved, clock() / 1e6);
        if (!solved) break;
        s.cover.forget_slack();
        auto more = s.cuts.violated(s.cover.unused());
        s.done = more.empty();
        s.cover.add(std::move(more));
    }
    return s.bound;
}

} // namespace filum::sequence
