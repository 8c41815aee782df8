// Sections of beads with rows: sets of intervals with exact ends.
#pragma once

#include "geom/vec.hpp"
#include "metrics/planar/cover.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace filum::metrics::planar {

using geom::Vec2;

// The most rows that sweep a layer.  Where the bead width alone decides, they are set farther apart to be no more.
inline constexpr double kMostRows = 200000;

struct Interval {
    double lo = 0, hi = 0;
    std::uint32_t slot = 0;
};

// A bead prepared for sections. Its outline is two half circles and two straight sides; on each side of the bead, the
// straight part is between the rows at `from` and `to`, and the circles are below and above it.
struct SweptBead {
    struct Side {
        double from = 0, to = 0; // y of the ends of the straight part
        double x = 0, slope = 0; // x of its lower end, and its change by y
    };
    Vec2 lower, upper;     // the ends of the bead
    double half = 0;       // mm, half the width
    double lo = 0, hi = 0; // y of the lowest and of the highest point
    Side left, right;      // towards small and large x
    std::uint32_t slot = 0;
};

[[nodiscard]] SweptBead swept_bead(const Bead& bead);

// By ascending lo.
std::vector<SweptBead> swept_beads(std::span<const Bead> beads);

// The section of the bead with the row at y, one interval because swept beads are convex; false if it is empty.
bool section(const SweptBead& bead, double y, Interval& out);

// Adds an interval to united ones. It comes after all of them in the order of slots and positions.
inline void add_united(const Interval& next, std::vector<Interval>& to) {
    if (!to.empty() && to.back().slot == next.slot && next.lo <= to.back().hi)
        to.back().hi = std::max(to.back().hi, next.hi);
    else
        to.push_back(next);
}

// Sorts by slot and position, and unites intervals of a slot that overlap.
void unite(std::vector<Interval>& intervals);

// Adds the lengths of part, beads and their intersection to `sum[slot]`. Precondition: both lists are united.
void tally(const std::vector<Interval>& part, const std::vector<Interval>& beads, double dy, std::span<Cover> sum);

// The length that two united lists of one slot share.
double shared_length(const std::vector<Interval>& a, const std::vector<Interval>& b);

// The sections of beads with one row after the other, upwards. The order of beads along a row hardly changes from row
// to row, so it is kept, and sorting takes little more than looking at each bead once.
class RowSweep {
  public:
    // `all` is as from swept_beads(), and outlives the sweep.
    explicit RowSweep(std::span<const SweptBead> all) : all_(all) {}

    // The united sections with the row at y, which lies above the last one.
    void move_to(double y, std::vector<Interval>& out);

  private:
    struct LiveBead {
        std::uint32_t bead = 0;
        bool meets = false;
        Interval at;
    };
    static bool before(const LiveBead& p, const LiveBead& q) {
        return p.at.slot != q.at.slot ? p.at.slot < q.at.slot : p.at.lo < q.at.lo;
    }

    std::span<const SweptBead> all_; // by ascending lo
    std::vector<LiveBead> live_;     // by slot and position
    std::size_t next_ = 0;           // of `all_`
};

} // namespace filum::metrics::planar
