// The linear program over cuts: the least number of links left unused if links can be used in part.
#pragma once

#include "sequence/cutting_planes.hpp"

#include <memory>

namespace filum::sequence {

// A lower bound on unused links from cuts and any prices: the sum of each cut's price times its least, minus the
// amounts by which the prices of a link's cuts exceed 1, since a link is left unused at most once (weak duality).
// Computed in integers, so the bound does not depend on the accuracy of the prices.
Index proven_unused(std::size_t links, const std::vector<Inequality>& cuts, std::span<const double> prices);

// Minimises the sum of unused[a] over the links, 0 <= unused[a] <= 1, subject to cuts, which are added step by step
// (dual simplex method of the GNU Linear Programming Kit). Very many solutions have the same value. So at first higher
// links, which have higher numbers, cost a little less: of stretches that overlap, a break at the head of the lowest
// one breaks the most. Without that, solutions move such a break from link to link, and each costs a cut.
class Cover {
  public:
    explicit Cover(std::size_t links);
    ~Cover();
    Cover(const Cover&) = delete;
    Cover& operator=(const Cover&) = delete;

    void add(std::vector<Inequality> cuts);
    // From now on all links cost the same.
    void make_exact();
    [[nodiscard]] bool is_exact() const;
    // Solves again. False if `budget` steps are not enough.
    bool solve(std::uint64_t budget);
    [[nodiscard]] const std::vector<double>& unused() const;
    // The bound that the solution proves, whether it is complete or not.
    [[nodiscard]] Index proven() const;
    // The source of the bound: the price of each cut times its least, distributed over its links.
    [[nodiscard]] std::vector<double> density() const;
    // Removes cuts that the solution satisfies with slack.
    void forget_slack();
    [[nodiscard]] std::uint64_t work() const; // steps taken so far

  private:
    struct Program;
    std::unique_ptr<Program> p_;
};

} // namespace filum::sequence
