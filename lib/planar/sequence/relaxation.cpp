#include "sequence/relaxation.hpp"

#include "sequence/cover.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace filum::sequence {

namespace {

// Columns along the links that are used most; each region has one successor and one predecessor at most.
Columns along_links(const Graph& g, std::span<const double> unused) {
    std::vector<Index> by_use(g.up.size()), from(g.up.size());
    std::iota(by_use.begin(), by_use.end(), 0U);
    std::stable_sort(by_use.begin(), by_use.end(), [&](Index a, Index b) { return unused[a] < unused[b]; });
    for (Index u = 0; u < g.size(); ++u)
        for (Index a = g.up.start[u]; a < g.up.start[u + 1]; ++a) from[a] = u;
    std::vector<Index> above(g.size(), kNone), below(g.size(), kNone);
    for (const Index a : by_use)
        if (const Index u = from[a], v = g.up.to[a]; above[u] == kNone && below[v] == kNone) {
            above[u] = v;
            below[v] = u;
        }
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

// The linear program of one slab.
struct Relaxation::Program {
    const Graph& g;
    Columns columns;
    std::optional<CuttingPlanes> cuts; // of `columns`
    Cover cover;
    Index unused = 0;         // number of links proven unused
    bool done = false;        // no cut is left
    std::uint64_t before = 0; // work for cuts of earlier columns

    Program(const Slab& s, std::uint64_t budget) : g(s.g), columns(s.columns), cover(s.g.up.size()) {
        cuts.emplace(g, columns, budget);
        auto first = cuts->degrees(), more = cuts->apart();
        first.insert(first.end(), more.begin(), more.end());
        unused = proven_unused(g.up.size(), first, std::vector<double>(first.size(), 1));
        cover.add(std::move(first));
    }
    [[nodiscard]] std::uint64_t work() const { return before + cuts->work() + cover.work(); }

    // Adds violated cuts; if there are none, those of columns along the current solution. If there are none of these,
    // makes the costs exact.
    void cut(std::uint64_t budget) {
        auto more = cuts->violated(cover.unused());
        if (more.empty()) {
            before += cuts->work();
            columns = along_links(g, cover.unused());
            cuts.emplace(g, columns, budget);
            more = cuts->violated(cover.unused());
        }
        if (more.empty() && !cover.is_exact()) return cover.make_exact();
        done = more.empty();
        cover.add(std::move(more));
    }

    void tighten(Index target, std::uint64_t limit) {
        while (!done && unused < target && work() < limit) {
            const bool solved = cover.solve(limit - work());
            unused = std::max(unused, cover.proven());
            if (!solved) break;
            cover.forget_slack();
            cut(limit > work() ? limit - work() : 0);
        }
    }
};

Relaxation::Relaxation(const Graph& g, const Columns& columns, std::size_t most_in_table)
    : regions_(g.size()), links_(static_cast<Index>(g.up.size())), slabs_(slabs(g, columns, most_in_table)),
      unused_(slabs_.size(), 0), density_(g.size(), 0) {}
Relaxation::~Relaxation() = default;

void Relaxation::enter(std::size_t slab, std::uint64_t budget) {
    if (program_ && entered_ == slab) return;
    program_ = std::make_unique<Program>(slabs_[slab], budget);
    entered_ = slab;
    work_ += program_->work();
}

// Distributes half of each link's price to either end, replacing earlier prices.
void Relaxation::price(std::size_t slab) {
    const Graph& g = slabs_[slab].g;
    const auto of_link = program_->cover.density();
    double* const out = density_.data() + slabs_[slab].first;
    std::fill(out, out + g.size(), 0.0);
    for (Index u = 0; u < g.size(); ++u)
        for (Index a = g.up.start[u]; a < g.up.start[u + 1]; ++a) {
            out[u] += of_link[a] / 2;
            out[g.up.to[a]] += of_link[a] / 2;
        }
}

Index Relaxation::bound() const {
    const Index least = regions_ + std::accumulate(unused_.begin(), unused_.end(), 0U);
    return least > links_ ? least - links_ : 0;
}

// The number of links that slab i must leave unused for `target` strokes.
Index Relaxation::wanted(Index target, std::size_t i) const {
    const std::int64_t others =
        std::int64_t{regions_} - links_ + std::accumulate(unused_.begin(), unused_.end(), std::int64_t{0}) - unused_[i];
    return static_cast<Index>(std::clamp<std::int64_t>(target - others, 0, kNone));
}

Index Relaxation::tighten(Index target, std::uint64_t budget) {
    for (std::size_t i = 0; i < slabs_.size() && bound() < target; ++i) {
        const std::uint64_t share = budget / std::max<Index>(1, links_) * slabs_[i].g.up.size();
        enter(i, share);
        const std::uint64_t before = program_->work();
        program_->tighten(wanted(target, i), before + share);
        work_ += program_->work() - before;
        unused_[i] = std::max(unused_[i], program_->unused);
        price(i);
    }
    return bound();
}

} // namespace filum::sequence
