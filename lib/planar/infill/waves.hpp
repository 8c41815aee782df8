// The lines of a gyroid's section. Private to lib/planar/infill.
#pragma once

#include "infill/infill.hpp"

#include <cstdint>
#include <vector>

namespace filum::infill {

// The lines of one layer. Where sin x cos y + sin y cos z + sin z cos x is 0, a gyroid, every line of a layer has one y
// for each x if |cos z| >= |sin z|, else one x for each y. u is that first coordinate and v the other one, mm. A line
// is a polyline with a knot at every kSteps-th of a wave. Lines 2 k and 2 k + 1 bound the even cell k.
//
// Where lines are few, even cells are narrower (even_width()): both lines of a cell come nearer to its middle.
class Waves {
  public:
    // Lines for lo <= u <= hi.
    Waves(const Lines& lines, double lo, double hi);
    // True if u is x and v is y, so that lines run along x.
    static bool along_x(const Lines& lines);

    [[nodiscard]] std::int64_t column(double u) const; // of knots: the one from knot(c) to knot(c + 1)
    [[nodiscard]] double knot(std::int64_t column) const { return static_cast<double>(column) * step_; }
    // The position v of line j at u, a place in `column` or on its border.
    [[nodiscard]] double at(std::int64_t column, double u, std::int64_t j) const;
    // The last line at or below v.
    [[nodiscard]] std::int64_t below(std::int64_t column, double u, double v) const;

  private:
    struct Pair {
        double lower, upper; // mm, of line 0 and line 1
    };
    std::int64_t first_ = 0; // knot
    std::vector<Pair> at_;   // per knot
    double step_, period_;   // mm
};

} // namespace filum::infill
