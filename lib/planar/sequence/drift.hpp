// How far regions move from layer to layer of a column, which bounds distances that were not measured.
#pragma once

#include "sequence/graph.hpp"
#include "sequence/outline.hpp"

namespace filum::sequence {

// How the loops of `a` move to those of `b`, loop by loop and vertex by vertex, without vertices on straight edges: all
// boundary points by `shift`, and then each by at most `rest` mm. No point of the shifted region is farther than `rest`
// from the other region: where the boundary does not pass a point, its winding number stays; where it passes, it ends
// within that distance.
struct Movement {
    geom::Vec2 shift;
    double rest = 0; // mm; infinite if the numbers of vertices differ
};
Movement movement(const polygon::Loops& a, const polygon::Loops& b);

// Movements along one column, summed from its foot. They are known between regions of the same `stretch`.
struct Drift {
    std::vector<geom::Vec2> shift; // mm
    std::vector<double> rest;      // mm
    std::vector<double> length;    // mm: sum of the lengths of shifts and rests
    std::vector<Index> stretch;
    [[nodiscard]] bool known(std::size_t i, std::size_t k) const { return stretch[i] == stretch[k]; }
    [[nodiscard]] double between(std::size_t i, std::size_t k) const; // mm: the way of a boundary point, at most
    [[nodiscard]] bool alone(std::size_t i) const;                    // in its stretch
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
