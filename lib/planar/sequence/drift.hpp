// How far regions move from layer to layer of a column, which bounds distances that were not measured.
#pragma once

#include "sequence/graph.hpp"
#include "sequence/outline.hpp"

namespace filum::sequence {

// How the region inside the loops `a` becomes the one inside `b`: each point x of its outline moves to
// scale * x + shift, and then by at most `rest` mm. Both walk round their loops at once, so that numbers and places of
// vertices do not matter. No point of the scaled and shifted region is farther than `rest` from the other region: where
// the outline does not pass a point, its winding number stays; where it passes, it ends within that distance.
struct Movement {
    double scale = 1;
    geom::Vec2 shift;
    double rest = 0; // mm; infinite if the numbers of loops differ
};
Movement movement(const polygon::Loops& a, const polygon::Loops& b);

// Movements along one column: from the foot of a stretch to each of its places, once by the sum of the movements from
// place to place, and once directly. They are known between regions of the same stretch.
struct Drift {
    std::vector<Movement> summed;    // `rest` counts in mm of the foot: divided by the scale of its place
    std::vector<Movement> from_foot; // of the stretch
    std::vector<double> length;      // mm: sum of the ways that a point of the outline moves from place to place
    std::vector<Index> stretch;
    std::vector<geom::Vec2> middle; // of the region's box
    std::vector<double> radius;     // mm: half the diagonal of the box
    [[nodiscard]] bool known(std::size_t i, std::size_t k) const { return stretch[i] == stretch[k]; }
    [[nodiscard]] double between(std::size_t i, std::size_t k) const; // mm: the way of a boundary point, at most
    [[nodiscard]] bool alone(std::size_t i) const;                    // in its stretch
    // The movement from place i to k with the smaller rest: by the sums, or by way of the foot.
    [[nodiscard]] Movement movement(std::size_t i, std::size_t k) const;
};
Drift drift(std::span<const Index> column, const std::vector<Outline>& outlines);
// The drift of the same outlines, all moved by `way`.
Drift shifted(Drift drift, geom::Vec2 way);

// What the distance between place i of column a and place m of column c can become if the one moves to place k and the
// other to place n; its bounds before were `d`. Columns that lean or grow the same way keep their distance, except for
// the common scale: only the difference of their movements counts. Also valid for what a carriage sees.
Bounds relative(const Drift& a, std::size_t i, std::size_t k, const Drift& c, std::size_t m, std::size_t n, Bounds d);

// A measured distance between a region of one column and a region of another.
struct RegionDistance {
    std::size_t i = 0, k = 0; // places in the columns
    Bounds distance, carriage;
};

// The measured distances between the regions of two columns, at most one for each difference of places: where both
// columns move the same way, regions as many layers apart have the same distance.
class RegionDistances {
  public:
    void add(const RegionDistance& d);
    // Calls visit(d) for the latest distance, and for those with the nearest differences of places above and below.
    template <class Visit>
    void near(std::size_t i, std::size_t k, Visit&& visit) const {
        if (all_.empty()) return;
        visit(all_[latest_]);
        const std::size_t above = at(difference(i, k));
        if (above < all_.size() && above != latest_) visit(all_[above]);
        if (above > 0 && above - 1 != latest_) visit(all_[above - 1]);
    }

  private:
    static long difference(std::size_t i, std::size_t k) { return static_cast<long>(k) - static_cast<long>(i); }
    [[nodiscard]] std::size_t at(long difference) const; // the first one that is no smaller
    std::vector<RegionDistance> all_;                    // ascending by the difference k - i
    std::size_t latest_ = 0;
};

} // namespace filum::sequence
