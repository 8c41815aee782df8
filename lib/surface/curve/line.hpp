// Lines on a surface: what paths on curved surfaces are made of.
#pragma once

#include "surface/sheet.hpp"

#include <span>

namespace filum::surface::curve {

using geom::Vec2;
using geom::Vec3;
using surface::kNone;
using surface::Surface;

// A point of a surface and a triangle in which it lies, borders included.
struct Place {
    std::uint32_t triangle = 0;
    Vec3 point; // mm
};

// A polyline whose points lie on the surface.  It is threaded if every stretch lies in the triangle of its first place,
// so that there are places wherever it crosses edges; else stretches leave the surface by the sag of their chord.  All
// here keep lines threaded that are, but for resampled().  A closed line runs on from its last point to its first.
struct Line {
    std::vector<Place> places;
    bool closed = false;

    [[nodiscard]] std::size_t size() const { return places.size(); }
    [[nodiscard]] const Vec3& operator[](std::size_t i) const { return places[i].point; }
};

Line line(const surface::Isoline& isoline);

double length(const Line& line); // mm, its closing stretch included

// Per point the way to it from the first, mm; one more for the end of a closed line, which is its length.
std::vector<double> arc_lengths(const Line& line);

// The place `way` mm along the threaded line (as by ways).  Ways beyond the ends: the ends; of a closed line: round
// again.
Place at(const Line& line, std::span<const double> ways, double way);

// The stretch of the line from `from` to `to` mm along it, open, with all points between; of a closed line `to` may be
// less than `from`, or up to its length beyond: it runs on over the first point.
Line part(const Line& line, std::span<const double> ways, double from, double to);

// Places of the threaded line in equal distances along it, as near to `step` mm as may be; ends stay.
Line resampled(const Line& line, double step);

void reverse(Line& line);

// Appends the open line `more`, which begins where `line` ends: within 1e-9 mm the last point of `line` is left out.
void append(Line& line, const Line& more);

// Per vertex the mean normal of its triangles, weighted by their angles there; unit.
std::vector<Vec3> vertex_normals(const Surface& s);

// The normal at a place, unit: those of the corners, interpolated.
Vec3 normal_at(const Surface& s, std::span<const Vec3> vertex_normals, const Place& place);

} // namespace filum::surface::curve
