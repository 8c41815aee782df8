// How far regions move from layer to layer of a column, which bounds distances that were not measured.
#pragma once

#include "sequence/graph.hpp"
#include "sequence/outline.hpp"

namespace filum::sequence {

// The most that a point of the boundary moves if the loops of `a` are led to those of `b`, loop by loop and vertex by
// vertex, without vertices that lie on straight edges; infinite if their numbers differ.  No
// point of one region is farther than that from the other region: where the boundary does not pass a point, the
// winding number there stays, and where it passes, it ends that near.
double displacement(const polygon::Loops& a, const polygon::Loops& b);

// Along one column: regions i and k of it, i < k, are apart by at most moved[k] - moved[i] if their `stretch` is the
// same; nothing is known of others.
struct Drift {
    std::vector<double> moved; // mm, summed from the foot
    std::vector<Index> stretch;
    [[nodiscard]] double between(std::size_t i, std::size_t k) const;
    [[nodiscard]] bool alone(std::size_t i) const; // in its stretch
};
Drift drift(std::span<const Index> column, const std::vector<Outline>& outlines);

inline constexpr double kBoxMargin = 0.1; // mm; a choice: it decides how often boxes are compared, never the result

// The distance of a region of one column to one of another, as measured last.
struct Measured {
    bool known = false;
    std::size_t i = 0, k = 0; // places in the columns
    double distance = 0;      // mm
    // Whether a point of one lies in the box about a point of the other, for a box of these sizes; `sure`: the same
    // holds with kBoxMargin more or less on each side.
    double half_x = 0, half_y = 0;
    bool in_box = false, sure = false;
};

} // namespace filum::sequence
