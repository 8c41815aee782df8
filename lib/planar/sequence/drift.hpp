// How far regions move from layer to layer of a column, which bounds distances that were not measured.
#pragma once

#include "sequence/graph.hpp"
#include "sequence/outline.hpp"

namespace filum::sequence {

// The greatest movement of a boundary point if the loops of `a` are moved to those of `b`, loop by loop and vertex by
// vertex, without vertices on straight edges; infinite if their numbers differ. No point of one region is farther than
// that from the other region: where the boundary does not pass a point, its winding number stays; where it passes, it
// ends within that distance.
double displacement(const polygon::Loops& a, const polygon::Loops& b);

// Displacements along one column: its regions i < k differ by at most moved[k] - moved[i] if their `stretch` is the
// same; otherwise by an unknown amount.
struct Drift {
    std::vector<double> moved; // mm, summed from the foot
    std::vector<Index> stretch;
    [[nodiscard]] double between(std::size_t i, std::size_t k) const;
    [[nodiscard]] bool alone(std::size_t i) const; // in its stretch
};
Drift drift(std::span<const Index> column, const std::vector<Outline>& outlines);

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
