// What beads about a place cover, point by point.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::surfpath::rows {

// A square about the origin of a chart, as points an eighth of a bead apart that each are covered or not.
class Swath {
  public:
    // `half`: mm from the middle of the square to its sides; what lies beyond does not count.
    Swath(double width, double half);

    void clear() { covered_.assign(covered_.size(), 0); }
    // Covers what is within half a width of p.
    void add(geom::Vec2 p);
    [[nodiscard]] double covered() const; // mm2

  private:
    double half_width_, grain_;
    int size_; // points of a side
    std::vector<std::uint8_t> covered_;
};

} // namespace filum::surfpath::rows
