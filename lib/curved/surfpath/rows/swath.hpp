// The area that beads around a place cover, on a grid.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::surfpath::rows {

// A square around the origin of a chart as grid points an eighth of a bead apart, each covered or not.
class Swath {
  public:
    // `half`: mm from the middle of the square to its sides; nothing outside counts.
    Swath(double width, double half);

    void clear() { covered_.assign(covered_.size(), 0); }
    // Covers the points within half a width of p.
    void add(geom::Vec2 p);
    [[nodiscard]] double covered() const; // mm2

  private:
    double half_width_, grain_;
    int size_; // grid points per side
    std::vector<std::uint8_t> covered_;
};

} // namespace filum::surfpath::rows
