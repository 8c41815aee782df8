// A lower bound on strokes by a cutting plane method.
#pragma once

#include "sequence/slabs.hpp"

#include <memory>

namespace filum::sequence {

// The number of strokes is that of regions minus that of links used. Cuts bound the use of some links; their best
// combination is a linear program, to which violated cuts are added until there are none. A large graph is divided
// into slabs: an order of all regions uses no more links of a slab than an order of the slab alone, so the numbers of
// unused links add up.
class Relaxation {
  public:
    // `most_in_table` limits regions times columns of a slab, and so the memory.
    Relaxation(const Graph& g, const Columns& columns, std::size_t most_in_table = 8'000'000);
    ~Relaxation();
    Relaxation(const Relaxation&) = delete;
    Relaxation& operator=(const Relaxation&) = delete;

    // Continues until `target` strokes are proven, `budget` more is used, or no cut is left. Returns the best bound so
    // far.
    Index tighten(Index target, std::uint64_t budget);
    // The contribution of each region's links to the bound, half to either end.
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
    std::vector<Index> unused_; // proven unused links of each slab
    std::vector<double> density_;
    std::unique_ptr<Program> program_; // of slab entered_
    std::size_t entered_ = 0;
    std::uint64_t work_ = 0;
};

} // namespace filum::sequence
