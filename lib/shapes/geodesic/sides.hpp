// The two sides of sources on a surface.
#pragma once

#include "geodesic/sources.hpp"

#include <string>
#include <vector>

namespace filum::geodesic {

// The sides of source lines. Vertices that are connected along edges without crossing a line are on the same side.
// That side is positive if the lines along it mostly (by length) have it on their left, seen from the side that the
// surface faces. Plane sections have the side of the plane's normal on their left; intersections with a mesh the side
// that the mesh faces; rims the whole surface. A part without lines along it, as around points, is positive.
struct Sides {
    std::vector<signed char> of; // per vertex 1 or -1; 0 on lines, and on components without a source
    double length = 0;           // mm, of all lines
    // mm of lines that have the negative side on their left or the positive one on their right. If it is more than a
    // little, the lines do not separate the surface (a line that ends inside it has the same part on both sides), or
    // they cross.
    double mixed = 0;
    std::vector<Segment> lines; // by triangle

    // The side of a point in the triangle: that of a corner from which no line separates it; 0 if there is none.
    [[nodiscard]] int at(const Surface& surface, std::uint32_t triangle, const Vec3& p) const;
};
Sides sides(const Surface& surface, const Sources& sources);

// Throws Error(usage), naming `use`, if the sources do not define sides: if they are only points, or if more than a
// hundredth of the lines is mixed.
void check(const Sides& sides, const std::string& use);

} // namespace filum::geodesic
