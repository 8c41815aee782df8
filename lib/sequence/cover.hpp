// The linear program over cuts: how little of the links can be left unused if links can be used in part.
#pragma once

#include "sequence/cuts.hpp"

#include <memory>

namespace filum::sequence {

// Links that no order can use, proven from cuts by any prices: a cut's price times its least, summed, less what the
// prices of a link's cuts exceed 1, is a bound because a link is left unused at most once (weak duality of the linear
// program).  Reckoned in whole numbers; so the bound does not rest on how well the prices were found.
Index proven_unused(std::size_t links, const std::vector<Cut>& cuts, std::span<const double> prices);

// Minimises the sum of unused[a] over the links, 0 <= unused[a] <= 1, subject to cuts that are added as they are found
// (dual simplex method of the GNU Linear Programming Kit).
class Cover {
  public:
    explicit Cover(std::size_t links);
    ~Cover();
    Cover(const Cover&) = delete;
    Cover& operator=(const Cover&) = delete;

    void add(std::vector<Cut> cuts);
    // Solves anew.  False if `budget` steps do not suffice.
    bool solve(std::uint64_t budget);
    [[nodiscard]] const std::vector<double>& unused() const;
    // What the solution, whether complete or not, proves.
    [[nodiscard]] Index proven() const;
    // Where the bound comes from: the price of each cut times its least, spread over its links.
    [[nodiscard]] std::vector<double> density() const;
    // Forgets cuts that the solution keeps with something to spare.
    void forget_slack();
    [[nodiscard]] std::uint64_t work() const; // steps taken so far

  private:
    struct Program;
    std::unique_ptr<Program> p_;
};

} // namespace filum::sequence
