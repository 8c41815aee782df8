// Inequalities that the strokes of every order satisfy (docs/algorithms/sequence.md#bounds).
#pragma once

#include "sequence/following.hpp"

#include <span>

namespace filum::sequence {

// Every order leaves at least `least` of these links unused.
struct Cut {
    std::vector<Index> link; // places in Graph::up.to, ascending
    Index least = 0;
};

// Where cuts come from.  A stretch is a run of regions of one column, from its foot to its head, and unbroken if the
// links between all of them are used; a region alone is an unbroken stretch.  Strokes are printed one after the other,
// so of two unbroken stretches one is printed as a whole before the other, and nothing is printed within one.
// - degrees: a stroke leaves a region to one other and comes to it from one other.
// - again: a region of another column must follow the foot of a stretch and precede its head; so that is broken.
// - rivals: k stretches of different columns such that the head of each must follow the foots of all others.  Of two
//   unbroken ones the one printed first would have its head before the other's foot; so k - 1 are broken.
// - circles: the head of each of some stretches must follow the foot of the one before it, all around.  Were all
//   unbroken, each would be printed as a whole after the one before it; so one is broken.  (Were two of them parts of
//   one stroke, a way around within it would lead down each of its links, and so stay in one column.)
class Cuts {
  public:
    Cuts(const Graph& g, const Columns& columns, std::uint64_t most_work);

    [[nodiscard]] std::vector<Cut> degrees() const;
    // As many cuts of the kind `again` as there are without a link in common: from below, the lowest head first.
    [[nodiscard]] std::vector<Cut> apart() const;

    // Cuts that `unused`, 0 .. 1 for each link, violates, the most violated first and each link in a few; rivals only
    // where there is no other, and circles last.
    std::vector<Cut> violated(std::span<const double> unused);

    [[nodiscard]] std::uint64_t work() const { return work_; }

  private:
    struct Stretch {
        Index column, foot, head;
        friend auto operator<=>(const Stretch&, const Stretch&) = default;
    };
    using Stretches = std::vector<Stretch>; // rivals
    struct Found {
        double by;
        Stretches stretches;
        Index least;
    };
    struct Walk;                                    // along the circles
    static constexpr double kLeastViolation = 0.02; // a smaller one is not worth a cut

    [[nodiscard]] double broken(Index c, Index foot, Index head) const {
        return so_far_[columns_.member[c][head]] - so_far_[columns_.member[c][foot]];
    }
    void sum_up(std::span<const double> unused);
    [[nodiscard]] std::vector<Found> again() const;
    [[nodiscard]] std::vector<Found> circles();
    [[nodiscard]] std::vector<Found> rivals();
    bool add_rival(Stretches& s, double& sum);
    void raise_feet(Stretches& s) const;
    [[nodiscard]] Cut cut(const Stretches& s, Index least) const;

    const Graph& g_;
    const Columns& columns_;
    Following following_;
    std::vector<Index> link_;    // of a region to the next of its column, kNone if there is none
    std::vector<double> so_far_; // breaks of its column below a region, in the solution at hand
    std::vector<Index> level_;   // the lowest place in its column with as many breaks below it
    Index turn_ = 0;             // where circles were last looked for
    std::uint64_t work_ = 0;
};

} // namespace filum::sequence
