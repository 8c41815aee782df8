// Which side of its sources a surface lies on.
#pragma once

#include "geodesic/sources.hpp"

#include <string>
#include <vector>

namespace filum::geodesic {

// The sides of the lines of some sources.  Vertices from which one can get to each other along edges without meeting a
// line are on the same side: on the positive one if the lines that border on them have them, by length, mostly to their
// left, seen from the side that the surface faces.  Plane sections have their normal's side there, meetings with a mesh
// the side that the mesh faces, rims all the surface.  Where no line borders, as around points, it is the positive one.
struct Sides {
    std::vector<signed char> of; // per vertex 1 or -1; 0 on lines, and on components without any source
    double length = 0;           // mm, of all lines
    // How much of it has a vertex of the negative side to its left, or of the positive one to its right, mm.  More than
    // a little: the lines do not separate the surface (one that ends within it has the same part on both sides), or
    // they cross each other.
    double mixed = 0;
    std::vector<Segment> lines; // by triangles

    // The side of a point of the triangle: that of a corner to which no line stands in the way; 0 if there is none.
    [[nodiscard]] int at(const Surface& surface, std::uint32_t triangle, const Vec3& p) const;
};
Sides sides(const Surface& surface, const Sources& sources);

// Throws Error(usage) unless they are good for telling signs, `use` being what wants that: the sources are points only,
// or more than a hundredth of the lines is mixed.
void check(const Sides& sides, const std::string& use);

} // namespace filum::geodesic
