#include "sequence/successors.hpp"

#include <algorithm>

namespace filum::sequence {

namespace {
constexpr std::size_t kAtOnce = 16; // places compared in the time of one step
} // namespace

Successors::Successors(const Graph& g, const Columns& columns, std::uint64_t most)
    : columns_(columns.member.size()), first_(g.size() * columns_, kNone), again_(g.size(), kNone) {
    std::vector<Index> place(g.size());
    for (const auto& member : columns.member)
        for (std::size_t i = 0; i < member.size(); ++i) place[member[i]] = static_cast<Index>(i);
    for (Index v = g.size(); v-- > 0;) {
        const Index own = columns.of[v];
        Index* const to = first_.data() + v * columns_;
        for (const Index w : g.after[v]) {
            const Index* const from = first_.data() + w * columns_;
            for (std::size_t c = 0; c < columns_; ++c) to[c] = std::min(to[c], from[c]);
            to[columns.of[w]] = std::min(to[columns.of[w]], place[w]);
            again_[v] = std::min(again_[v], columns.of[w] == own ? again_[w] : first(w, own));
        }
        work_ += (g.after[v].size() + 1) * columns_ / kAtOnce + 1;
        if (work_ > most) break;
    }
}

} // namespace filum::sequence
