// Where along a row the exact distance is below a level: without refinement, from the windows themselves.
#pragma once

#include "geodesic/exact.hpp"

namespace filum::metrics::surface {

using geom::Vec3;

// A part of a row, from 0 at its begin to 1 at its end.
struct Part {
    double lo, hi;
};

// Rows across one triangle, and where on them a field is at most a level: per row the union of convex pieces, of which
// each window, source and corner gives one at most three (a disc within the angle that the window sees, a strip on one
// side of a line), with ends solved for.
class Rows {
  public:
    Rows(const filum::surface::Surface& surface, const geodesic::ExactField& field, std::uint32_t triangle,
         double level);

    // Appends the parts of the row from `a` to `b`, points of the triangle; unsorted, they may overlap.
    void below(const Vec3& a, const Vec3& b, std::vector<Part>& out) const;

  private:
    struct Seen {
        std::uint32_t side; // 0 to 2
        geodesic::Window window;
    };
    const filum::surface::Surface& surface_;
    const geodesic::ExactField& field_;
    std::uint32_t triangle_;
    double level_;
    std::vector<Seen> seen_;
    std::vector<filum::surface::Segment> segments_;
};

// Sorts the parts and joins those that overlap or touch within 1e-7.
void unite(std::vector<Part>& parts);

double total(const std::vector<Part>& united);

// What lies in both.  Precondition: both united.
std::vector<Part> common(const std::vector<Part>& a, const std::vector<Part>& b);

} // namespace filum::metrics::surface
