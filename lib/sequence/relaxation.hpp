// A lower bound for strokes from cuts that are priced against each other.
#pragma once

#include "sequence/graph.hpp"

#include <memory>

namespace filum::sequence {

// Strokes are the regions less the links used.  Cuts say what no order can use of some links; the best way to add them
// up is a linear program, to which violated cuts are added until there are none (a cutting plane method).
class Relaxation {
  public:
    Relaxation(const Graph& g, const Columns& columns, std::uint64_t budget);
    ~Relaxation();
    Relaxation(const Relaxation&) = delete;
    Relaxation& operator=(const Relaxation&) = delete;

    // Goes on until `target` strokes are proven, `budget` more is used or no cut is left; the best bound so far.
    Index tighten(Index target, std::uint64_t budget);
    // How much of the bound is owed to the links of each region, half to either end.
    [[nodiscard]] std::vector<double> density() const;
    [[nodiscard]] std::uint64_t work() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::sequence
