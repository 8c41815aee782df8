// Walks straight on over a surface, and draws lines on it.
#pragma once

#include "surface/curve/line.hpp"

#include <array>

namespace filum::surface::curve {

// The weights of the corners of the place's triangle, with sum 1; below 0 only by rounding, or for points outside.
std::array<double, 3> barycentric(const Surface& s, const Place& place);

// Whether the point is in the triangle, borders included.
bool lies_in(const Surface& s, std::uint32_t triangle, const Vec3& point);

// The place that is reached from `from` by the tangential part of vector `way`: straight within triangles, and across
// edges as if both triangles were coplanar (Polthier, Schmies 1998). A rim ends the way. Crossings with edges and the
// end are appended to `crossed` if that is given.
Place step(const Surface& s, const Place& from, const Vec3& way, Line* crossed = nullptr);

// The straightest line from `from` in `direction`, `length` mm long or up to a rim, with its ends and all crossings
// with edges. `direction` must have a tangential part.
Line walk(const Surface& s, const Place& from, const Vec3& direction, double length);

// A tangent plane as a map of the surroundings of a place.
struct Chart {
    Vec3 origin, x, y, normal; // unit axes, right-handed

    [[nodiscard]] Vec2 to(const Vec3& p) const { return {dot(p - origin, x), dot(p - origin, y)}; }
};

// The chart at `place` whose x axis is the projection of `heading` to the plane perpendicular to `normal`.
Chart chart(const Place& place, const Vec3& normal, const Vec3& heading);

// The line on the surface whose projection to the chart is the polyline `way`, with all crossings with edges. It
// begins at `from`, which projects to the first point. It ends early, and `whole` is false, at a rim or where the
// surface is inclined to the chart by more than 80 degrees.
struct ChartLine {
    Line line;
    bool whole = true;
};
ChartLine from_chart(const Surface& s, const Chart& chart, const Place& from, std::span<const Vec2> way);

// The line with places wherever it crosses edges; each segment by join().
Line threaded(const Surface& s, const Line& line);

// The line from `a` to `b` in the plane through both that is perpendicular to the surface; only the two places if that
// does not connect them.
Line join(const Surface& s, const Place& a, const Place& b);

// Whether a line made by join() lies on the surface. If it consists of two places in different triangles, it does not.
bool leads(const Surface& s, const Line& joined);

// The place with a triangle that contains its point, or the nearest one, among the triangles that share a corner with
// its own, up to three steps away. Needed after joining or splitting lines.
Place settled(const Surface& s, Place p);

} // namespace filum::surface::curve
