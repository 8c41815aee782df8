// Strands whose distance changes from place to place: fronts that advance one spacing at a time.
#pragma once

#include "fill/scaffold/strands.hpp"

#include <functional>

namespace filum::fill::scaffold {

// The distance between strands at a place, mm.
using SpacingAt = std::function<double(Vec2)>;

// Lines y(x) across a box. Line 0 is straight, in its middle. Line k is the front that starts from line 0 and advances
// at each place by the spacing there for each whole number, at right angles to itself. So neighbouring lines are
// everywhere as far apart as the spacing says. Where it changes along the lines, they fan or bend; where two parts of a
// front meet, it has a corner. Fractions between whole numbers have their lines, too.
//
// The lines are those of dY/dk = s(x, Y) sqrt(1 + Y'^2), solved upwind (Godunov) on columns of the box.
class Fronts {
  public:
    // `resolution`: mm between columns, at least. Throws Error(usage) if the spacing differs within the box by more
    // than a factor of kMostRatio.
    Fronts(const geom::Box2& box, double resolution, const SpacingAt& spacing);

    // The number of the line through a point of the box.
    [[nodiscard]] double level(Vec2 p) const;
    // The height of a line.
    [[nodiscard]] double y(double x, double level) const;
    // The strand at a level from one x to another.
    [[nodiscard]] std::vector<Vec2> line(double from, double to, double level) const;
    [[nodiscard]] double column_width() const { return step_; }

    static constexpr double kMostRatio = 10;

  private:
    [[nodiscard]] std::pair<std::size_t, double> column(double x) const;
    [[nodiscard]] double row_y(std::size_t row, std::size_t column, double share) const;

    double left_ = 0, step_ = 0;            // mm: x of the first column, distance of columns
    double first_ = 0, per_row_ = 0;        // level of the first row, and from row to row
    std::vector<std::vector<double>> rows_; // y by row and column, ascending
};

// strand_graph() with strands along fronts. `levels` are ascending. The curves of all strands are in `line`.
StrandGraph bent_strand_graph(const Loops& area, const Fronts& fronts, std::span<const double> levels, double shortest,
                              std::optional<Vec2> start);

} // namespace filum::fill::scaffold
