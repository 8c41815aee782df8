// Isolines of distances on a surface.
#pragma once

#include "geodesic/exact.hpp"
#include "surface/sheet.hpp"

#include <functional>
#include <span>

namespace filum::geodesic {

using surface::Isoline;

// A place on an edge: the half-edge of lower number, and mm from its tail.
struct EdgePlace {
    std::uint32_t h = 0;
    double x = 0;
};

// Sets `out` to the places where the distance along half-edge `h` crosses `level`: mm from its tail, between its ends,
// ascending.
using Crosser = std::function<void(std::uint32_t h, double level, std::vector<double>& out)>;

// The isolines at `levels` (ascending) of distances at the vertices, in the order of levels; within a level open ones
// come first, which begin and end at rims, then closed ones, in the order of their first places. `cross` computes
// where they cross edges; within a triangle they are straight. If a triangle's border is crossed more than twice,
// `at`, the distance at the mean of the crossings, decides which are connected. Edges with an infinite end are not
// crossed. `begins` gets the first place of each isoline.
using Inside = std::function<double(std::uint32_t triangle, const Vec3& p)>;
std::vector<Isoline> isolines(const Surface& surface, std::span<const double> distance, std::span<const double> levels,
                              const Crosser& cross, const Inside& at, std::vector<EdgePlace>* begins = nullptr);

// Whether the distance along an edge may cross the level: it changes by no more than the length, or a little more for
// inexact fields.
inline bool within_reach(double tail, double head, double length, double level) {
    return level >= std::min({tail, head, (tail + head - length) / 2}) &&
           level <= std::max({tail, head, (tail + head + length) / 2});
}

// Inserts points into segments of `line` whose middle deviates from the level by more than `tolerance` mm, until none
// does; at most 63 per segment.
void refine(const Surface& surface, Isoline& line, const Inside& at, double tolerance);

// The isolines of an exact field: crossings are solved from its windows, and lines are refined to 0.001 mm.
std::vector<Isoline> isolines(const Surface& surface, const ExactField& field, std::span<const double> levels,
                              std::vector<EdgePlace>* begins = nullptr);

// The levels, ascending, slightly raised where one equals the distance of a vertex, which is common on grids: rounding
// would break the isolines there. `apart` is the distance of the levels, mm.
std::vector<double> off_vertices(std::vector<double> levels, std::vector<double> distance, double apart);

// The isolines of a function that is linear on every triangle.
std::vector<Isoline> isolines(const Surface& surface, std::span<const double> distance, std::span<const double> levels);

} // namespace filum::geodesic
