// What must follow a region, column by column.
#pragma once

#include "sequence/graph.hpp"

namespace filum::sequence {

// Precedence is transitive and columns are printed upwards, so what must follow a region is, per column, one place and
// everything above it.
class Successors {
  public:
    // Takes precedences times columns steps; for regions below those at which `most` is used up nothing is known.
    Successors(const Graph& g, const Columns& columns, std::uint64_t most);

    // The lowest place in column c whose region must follow v, other than v; kNone if none.
    [[nodiscard]] Index first(Index v, Index c) const { return first_[std::size_t{v} * columns_ + c]; }
    // The lowest place in v's own column whose region must follow a region of another column that must follow v.
    [[nodiscard]] Index again(Index v) const { return again_[v]; }
    [[nodiscard]] std::uint64_t work() const { return work_; }

  private:
    std::size_t columns_ = 0;
    std::vector<Index> first_, again_;
    std::uint64_t work_ = 0;
};

} // namespace filum::sequence
