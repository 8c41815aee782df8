// A lower bound for strokes from cuts that are priced against each other.
#pragma once

#include "sequence/slabs.hpp"

#include <memory>

namespace filum::sequence {

// Strokes are the regions less the links used.  Cuts say what no order can use of some links; the best way to add them
// up is a linear program, to which violated cuts are added until there are none (a cutting plane method).  A large
// graph is cut into slabs: an order of all regions uses no more of the links in a slab than an order of the slab alone
// can, so what they leave unused adds up.
class Relaxation {
  public:
    // `most_in_table` bounds regions times columns of a slab, and with it the memory.
    Relaxation(const Graph& g, const Columns& columns, std::size_t most_in_table = 8'000'000);
    ~Relaxation();
    Relaxation(const Relaxation&) = delete;
    Relaxation& operator=(const Relaxation&) = delete;

    // Goes on until `target` strokes are proven, `budget` more is used or no cut is left; the best bound so far.
    Index tighten(Index target, std::uint64_t budget);
    // How much of the bound is owed to the links of each region, half to either end.
    [[nodiscard]] const std::vector<double>& density() const { return density_; }
    [[nodiscard]] std::uint64_t work() const { return work_; }

  private:
    struct Program;
    void enter(std::size_t slab, std::uint64_t budget);
    void price(std::size_t slab);
    [[nodiscard]] Index bound() const;
    [[nodiscard]] Index wanted(Index target, std::size_t slab) const;

    Index regions_ = 0, links_ = 0;
    std::vector<Slab> slabs_;
    std::vector<Index> unused_; // links of each slab, proven
    std::vector<double> density_;
    std::unique_ptr<Program> program_; // of slab entered_
    std::size_t entered_ = 0;
    std::uint64_t work_ = 0;
};

} // namespace filum::sequence
