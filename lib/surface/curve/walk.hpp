// Going straight on over a surface.
#pragma once

#include "surface/curve/line.hpp"

#include <array>

namespace filum::surface::curve {

// Weights of the corners of its triangle, of sum 1; below 0 only by rounding, or for points off the triangle.
std::array<double, 3> barycentric(const Surface& s, const Place& place);

// True if the point lies in the triangle, borders included.
bool lies_in(const Surface& s, std::uint32_t triangle, const Vec3& point);

// Where one comes to from `from` by the vector `way`, of which the part along the surface counts: straight on within
// triangles, and over their edges as if both were flat (Polthier, Schmies 1998).  A rim ends it.
// Adds the places where it crosses edges, and where it ends, to `crossed` if that is given.
Place step(const Surface& s, const Place& from, const Vec3& way, Line* crossed = nullptr);

// The straightest line from `from` towards `direction`, `length` mm long or up to a rim: with its ends and all places
// where it crosses edges.  `direction` has a part along the surface.
Line walk(const Surface& s, const Place& from, const Vec3& direction, double length);

// A plane that touches the surface somewhere, as a map of what lies around there.
struct Chart {
    Vec3 origin, x, y, normal; // axes: unit, right-handed

    [[nodiscard]] Vec2 to(const Vec3& p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
};

// The chart at `place` whose x axis points to `heading` as far as the plane across `normal` allows.
Chart chart(const Place& place, const Vec3& normal, const Vec3& heading);

// The line whose shadow on the chart is the polyline `way`, beginning at `from`, whose shadow is the first point: with
// all places where it crosses edges.  Stops early at a rim, or where the surface turns away from the chart by more than
// 80 degrees; then `whole` is false.
struct Laid {
    Line line;
    bool whole = true;
};
Laid lay(const Surface& s, const Chart& chart, const Place& from, std::span<const Vec2> way);

// The line with places wherever it crosses edges, each stretch by join().
Line threaded(const Surface& s, const Line& line);

// The line from `a` to `b` on the plane through both that stands upright on the surface; only both if that does not
// lead there.
Line join(const Surface& s, const Place& a, const Place& b);

// True if a line made by join() lies on the surface: it is two places only where none leads from one to the other, or
// both lie in one triangle.
bool leads(const Surface& s, const Line& joined);

// The place in the triangle that its point lies in, or nearest to, among the triangle's own and those that meet it at a
// corner, up to three such steps away: where lines were joined or parted, the point may lie in another one.
Place settled(const Surface& s, Place p);

} // namespace filum::surface::curve
