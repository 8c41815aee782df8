// Cutting planes: inequalities that the strokes of every order satisfy (docs/algorithms/sequence.md#bounds).
#pragma once

#include "sequence/successors.hpp"

#include <span>

namespace filum::sequence {

// Every order leaves at least `least` of these links unused.
struct Inequality {
    std::vector<Index> link; // indices in Graph::up.to, ascending
    Index least = 0;
};

// Generates cuts. A stretch is a run of regions of one column, from its foot to its head; it is unbroken if all links
// between them are used; a single region is an unbroken stretch. Strokes are printed one after the other, so of two
// unbroken stretches one is printed completely before the other, and nothing is printed within one.
// - degrees: at most one link leaves a region, and at most one enters it.
// - again: a region of another column must follow the foot of a stretch and precede its head; so the stretch is
//   broken.
// - rivals: k stretches of different columns such that the head of each must follow the feet of all others. Of two
//   unbroken ones the one printed first would have its head before the other's foot; so k - 1 are broken.
// - circles: the head of each of some stretches must follow the foot of the one before it, cyclically. If all were
//   unbroken, each would be printed completely after the one before it; so one is broken. (If two of them were parts of
//   one stroke, the path around within it would lead down along each of its links, and so stay in one column.)
class CuttingPlanes {
  public:
    CuttingPlanes(const Graph& g, const Columns& columns, std::uint64_t most_work);

    [[nodiscard]] std::vector<Inequality> degrees() const;
    // A maximal set of cuts of the kind `again` without common links: from below, the lowest head first.
    [[nodiscard]] std::vector<Inequality> apart() const;

    // The cuts that `unused`, 0 to 1 per link, violates, the most violated first, with each link in a few of them;
    // rivals only if there are no others, and circles last.
    std::vector<Inequality> violated(std::span<const double> unused);

    [[nodiscard]] std::uint64_t work() const { return work_; }

  private:
    struct Stretch {
        Index column, foot, head;
        friend auto operator<=>(const Stretch&, const Stretch&) = default;
    };
    using Stretches = std::vector<Stretch>; // rivals
    struct Violation {
        double by;
        Stretches stretches;
        Index least;
    };
    struct CircleSearch;                            // searches circles
    static constexpr double kLeastViolation = 0.02; // smaller violations are not worth a cut

    [[nodiscard]] double broken(Index c, Index foot, Index head) const {
        return so_far_[columns_.member[c][head]] - so_far_[columns_.member[c][foot]];
    }
    void sum_up(std::span<const double> unused);
    [[nodiscard]] std::vector<Violation> again() const;
    [[nodiscard]] std::vector<Violation> circles();
    [[nodiscard]] std::vector<Violation> rivals();
    bool add_rival(Stretches& s, double& sum);
    void raise_feet(Stretches& s) const;
    [[nodiscard]] Inequality cut(const Stretches& s, Index least) const;

    const Graph& g_;
    const Columns& columns_;
    Successors successors_;
    std::vector<Index> link_;    // from a region to the next one of its column, kNone if there is none
    std::vector<double> so_far_; // breaks below a region in its column, in the current solution
    std::vector<Index> level_;   // the lowest place in its column with as many breaks below it
    Index turn_ = 0;             // where the last search for circles stopped
    std::uint64_t work_ = 0;
};

} // namespace filum::sequence
