// How far regions move from layer to layer of a column, which bounds distances that were not measured.
#pragma once

#include "sequence/graph.hpp"
#include "sequence/outline.hpp"

namespace filum::sequence {

// How the region inside the loops `a` becomes the one inside `b`: its outline moves by `shift`, and then each of its
// points by at most `rest` mm. Both walk round their loops at once, so that numbers and places of vertices do not
// matter. No point of the shifted region is farther than `rest` from the other region: where the outline does not pass
// a point, its winding number stays; where it passes, it ends within that distance.
struct Movement {
    geom::Vec2 shift;
    double rest = 0; // mm; infinite if the numbers of loops differ
};
Movement movement(const polygon::Loops& a, const polygon::Loops& b);

// Movements along one column: from each place to the next, summed from the foot, and from the foot of a stretch to each
// of its places. They are known between regions of the same stretch.
struct Drift {
    std::vector<geom::Vec2> shift;   // mm, summed
    std::vector<double> rest;        // mm, summed
    std::vector<double> length;      // mm: sum of the lengths of shifts and rests
    std::vector<Movement> from_foot; // of the stretch
    std::vector<Index> stretch;
    [[nodiscard]] bool known(std::size_t i, std::size_t k) const { return stretch[i] == stretch[k]; }
    [[nodiscard]] double between(std::size_t i, std::size_t k) const; // mm: the way of a boundary point, at most
    [[nodiscard]] bool alone(std::size_t i) const;                    // in its stretch
    // The movement from place i to k with the smaller rest: by the sums, or by way of the foot.
    [[nodiscard]] Movement movement(std::size_t i, std::size_t k) const;
};
Drift drift(std::span<const Index> column, const std::vector<Outline>& outlines);

// How much the distance between a region of column a and one of column c can change, mm, if the one moves from place i
// to k and the other from place m to n. Columns that lean the same way keep their distance: common shifts do not count.
double relative(const Drift& a, std::size_t i, std::size_t k, const Drift& c, std::size_t m, std::size_t n);

inline constexpr double kBoxMargin = 0.1; // mm; affects how often boxes are compared, never the result

// The last measured distance between a region of one column and a region of another.
struct RegionDistance {
    bool known = false;
    std::size_t i = 0, k = 0; // places in the columns
    double distance = 0;      // mm
    // Whether a point of one region is in the box of these sizes around a point of the other; `sure`: the same holds
    // for boxes larger or smaller by kBoxMargin on each side.
    double half_x = 0, half_y = 0;
    bool in_box = false, sure = false;
};

} // namespace filum::sequence
