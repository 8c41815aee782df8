// The positions of parallel lines. Private to lib/planar/infill.
#pragma once

#include "infill/infill.hpp"

#include <vector>

namespace filum::infill {

// Bead widths: even cells between rows and waves are no wider. The ends of an even cell follow the wall; where lines
// are few, wide cells would lay more along the wall than between the walls. Skins reach over a sparse area by half of
// this at most, so wider cells carry no skin anyway.
inline constexpr double kWidestCell = 16;

// The width of even cells in mm: the spacing, but at most kWidestCell beads between rows and waves.
double even_width(const Lines& lines, double spacing);

// The positions of lines across their direction, mm. Two lines lie in each period of two spacings: an even cell, as
// wide as even_width(), then an odd cell with the rest. An even cell ends one spacing from the origin. So a part about
// the origin, as most are, has the fewer lines the wider the spacing, and none at last.
//
// If no gap may be wider than Lines::gap, the odd cell is first divided into an odd number of cells as wide as the even
// one at most. Then each cell gets further lines. The first and last of these keep gap / 2 from the borders of the
// cell, which continue below and carry them. That distance is at least kNearest beads and at most a third of the cell.
// The distance between those two is divided evenly by an odd number.
//
// So each cell has an odd number of steps, and even cells continue in even ones. No two lines are so near that the cell
// between them would be too narrow.
class Ruler {
  public:
    explicit Ruler(const Lines& lines);

    // The borders of the cells before they get further lines: the sides of squares (squares.hpp).
    static Ruler of_squares(const Lines& lines);

    // The position of line j, mm.
    [[nodiscard]] double place(double j) const;
    // The inverse of place(), linear between lines.
    [[nodiscard]] double line(double v) const;
    // The last line at or below v.
    [[nodiscard]] double below(double v) const;
    // The part of begin .. v in even cells, mm, for the begin of some even cell; negative for v before it.
    [[nodiscard]] double even(double v) const;

  private:
    struct Step {
        double whole;  // periods
        std::size_t k; // the step within the period
        double share;  // of the step
    };
    Ruler(const Lines& lines, bool squares);
    void add_cell(double width, const Lines& lines);
    [[nodiscard]] Step step_at(double v) const;

    double begin_, period_, steps_ = 1; // begin_: mm, of an even cell
    std::vector<double> at_{0};         // positions within one period, both ends included
    std::vector<double> even_;          // mm of even cells before each
};

// The spacing of even waves or circles with no gap wider than Lines::gap.
double near_enough(const Lines& lines);

} // namespace filum::infill
