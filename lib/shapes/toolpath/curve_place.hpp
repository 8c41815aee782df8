// Places on a curve, by arc length.
#pragma once

#include "toolpath/path.hpp"

#include <vector>

namespace filum::toolpath {

// A point between points i and i + 1 of a curve; the last segment of a closed curve ends at its first point.
struct CurvePlace {
    std::size_t i = 0;
    double t = 0; // fraction of that segment
    geom::Vec2 point;
    double along = 0; // mm from the first point
    double off = 0;   // mm from the query point
};

// Arc length from the first point to each point, mm; of a closed curve followed by its length.
std::vector<double> arc_lengths(const Curve& curve);

// The place `along` mm from the first point; `sums` is arc_lengths(curve).
CurvePlace place_at(const Curve& curve, const std::vector<double>& sums, double along);

// The place nearest to p; ties: the first along the curve.
CurvePlace nearest_place(const Curve& curve, const std::vector<double>& sums, geom::Vec2 p);

// The width of the bead at the place, mm.
double width_at(const Curve& curve, const CurvePlace& place);

// Appends the bead from one place to another, both included; on a closed curve across its first point if necessary.
void add_stretch(const Curve& curve, const CurvePlace& from, const CurvePlace& to, Curve& out);

// Appends a point unless it is nearer to the last one than half of kLeastMove.
void add_point(Curve& to, geom::Vec2 p, double width);

} // namespace filum::toolpath
