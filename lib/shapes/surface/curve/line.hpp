// Lines on a surface: the parts of paths on curved surfaces.
#pragma once

#include "surface/sheet.hpp"

#include <span>

namespace filum::surface::curve {

using geom::Vec2;
using geom::Vec3;
using surface::kNone;
using surface::Surface;

// A point of a surface with a triangle that contains it, borders included.
struct Place {
    std::uint32_t triangle = 0;
    Vec3 point; // mm
};

// A polyline with its points on the surface. It is threaded if every segment lies in the triangle of its first place,
// that is, if it has places wherever it crosses edges; segments of other lines leave the surface by the sag of their
// chords. All functions here keep threaded lines threaded, except resampled(). A closed line continues from its last
// point to its first.
struct Line {
    std::vector<Place> places;
    bool closed = false;

    [[nodiscard]] std::size_t size() const { return places.size(); }
    [[nodiscard]] const Vec3& operator[](std::size_t i) const { return places[i].point; }
};

Line line(const surface::Isoline& isoline);

double length(const Line& line); // mm, including the closing segment

// Arc length of every point from the first, mm, and for a closed line one more, its length.
std::vector<double> arc_lengths(const Line& line);

// The place at arc length `way` of the threaded line; `ways` are its arc lengths. Arc lengths beyond the ends give the
// ends; on a closed line they wrap around.
Place at(const Line& line, std::span<const double> ways, double way);

// The part of the line between arc lengths `from` and `to`, open, with all points in between. On a closed line `to`
// may be less than `from`, or exceed it by up to the length: the part then contains the first point.
Line part(const Line& line, std::span<const double> ways, double from, double to);

// Places of the threaded line at equal distances, as near to `step` mm as possible; ends stay.
Line resampled(const Line& line, double step);

void reverse(Line& line);

// Appends the open line `more`, which begins where `line` ends; within 1e-9 mm the last point of `line` is left out.
void append(Line& line, const Line& more);

// Per vertex the mean normal of its triangles weighted by their angles there; unit.
std::vector<Vec3> vertex_normals(const Surface& s);

// The unit normal at a place, interpolated from the corners' normals.
Vec3 normal_at(const Surface& s, std::span<const Vec3> vertex_normals, const Place& place);

} // namespace filum::surface::curve
