// Places on a curve by arc length.
#pragma once

#include "toolpath/path.hpp"

#include <vector>

namespace filum::toolpath {

// Between points i and i + 1 of a curve; the last segment of a closed one leads back to its first point.
struct CurvePlace {
    std::size_t i = 0;
    double t = 0; // share of that segment
    geom::Vec2 point;
    double along = 0; // mm from the first point
    double off = 0;   // mm from the point it was asked for
};

// mm from the first point to each point; of a closed curve one more, its length.
std::vector<double> arc_lengths(const Curve& curve);

// The place `along` mm from the first point; sums: arc_lengths(curve).
CurvePlace place_at(const Curve& curve, const std::vector<double>& sums, double along);

// The place nearest to p; ties: the first.
CurvePlace nearest_place(const Curve& curve, const std::vector<double>& sums, geom::Vec2 p);

// mm, of the bead there.
double width_at(const Curve& curve, const CurvePlace& place);

// Adds the bead from one place on to another, both included; a closed curve runs over its first point where need be.
void add_stretch(const Curve& curve, const CurvePlace& from, const CurvePlace& to, Curve& out);

// Adds a point unless it is nearer to the last one than half of kLeastMove.
void add_point(Curve& to, geom::Vec2 p, double width);

} // namespace filum::toolpath
