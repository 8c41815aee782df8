// What must follow a region, column by column.
#pragma once

#include "sequence/graph.hpp"

namespace filum::sequence {

// Precedence is transitive and a column is printed from below, so what must follow a region is one place per column and
// all above it.
class Following {
  public:
    // Looks at precedences times columns; nothing is known of the regions below those where `most` is used up.
    Following(const Graph& g, const Columns& columns, std::uint64_t most);

    // The lowest place in column c whose region must follow v, other than v; kNone if none.
    [[nodiscard]] Index first(Index v, Index c) const { return first_[std::size_t{v} * columns_ + c]; }
    // The lowest place in v's own column whose region must follow one of another column that must follow v.
    [[nodiscard]] Index again(Index v) const { return again_[v]; }
    [[nodiscard]] std::uint64_t work() const { return work_; }

  private:
    std::size_t columns_ = 0;
    std::vector<Index> first_, again_;
    std::uint64_t work_ = 0;
};

} // namespace filum::sequence
