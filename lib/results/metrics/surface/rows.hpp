// The parts of a row on which the exact distance is below a level, computed from the windows without refinement.
#pragma once

#include "geodesic/exact.hpp"

namespace filum::metrics::surface {

using geom::Vec3;

// A part of a row, which runs from 0 to 1.
struct Interval {
    double lo, hi;
};

// Rows in one triangle, and the parts of them where a field is at most a level. Per row this is a union of intervals;
// each window, source and corner gives at most three (a disc within the angle that the window sees, a strip on one
// side of a line), whose ends are solved exactly.
class Rows {
  public:
    Rows(const filum::surface::Surface& surface, const geodesic::ExactField& field, std::uint32_t triangle,
         double level);

    // Appends the intervals of the row from `a` to `b`, points of the triangle; unsorted, possibly overlapping.
    void below(const Vec3& a, const Vec3& b, std::vector<Interval>& out) const;

  private:
    struct SideWindow {
        std::uint32_t side; // 0 to 2
        geodesic::Window window;
    };
    const filum::surface::Surface& surface_;
    const geodesic::ExactField& field_;
    std::uint32_t triangle_;
    double level_;
    std::vector<SideWindow> windows_;
    std::vector<filum::surface::Segment> segments_;
};

// Sorts the intervals and unites those that overlap or touch within 1e-7.
void unite(std::vector<Interval>& parts);

double total(const std::vector<Interval>& united);

// The intersection. Precondition: both united.
std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b);

} // namespace filum::metrics::surface
