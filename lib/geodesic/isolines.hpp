// Lines of equal distance on a surface.
#pragma once

#include "geodesic/exact.hpp"
#include "surface/sheet.hpp"

#include <functional>
#include <span>

namespace filum::geodesic {

using surface::Isoline;

// A place on an edge: its lesser half-edge, and mm from that one's tail.
struct OnEdge {
    std::uint32_t h = 0;
    double x = 0;
};

// Appends to `out`, which it clears, where the distance along half-edge `h` passes `level`: mm from its tail, between
// its ends, ascending.
using Crosser = std::function<void(std::uint32_t h, double level, std::vector<double>& out)>;

// The isolines at `levels` (ascending) of the distances at the vertices, in the order of the levels; at one level first
// those that begin and end at rims, then closed ones, by their first places.  `cross` tells where they cross edges;
// within a triangle they are straight.  Where a triangle's rim is crossed more than twice, the distance at the middle
// of the crossings, which `at` tells, decides what is joined.  Edges with an infinite end are not crossed.
using Inside = std::function<double(std::uint32_t triangle, const Vec3& p)>;
std::vector<Isoline> isolines(const Surface& surface, std::span<const double> distance, std::span<const double> levels,
                              const Crosser& cross, const Inside& at, std::vector<OnEdge>* begins = nullptr);

// Whether the distance along an edge of this length may pass the level: it changes by no more than the way, or some
// more for fields that are not exact.
inline bool within_reach(double tail, double head, double length, double level) {
    return level >= std::min({tail, head, (tail + head - length) / 2}) &&
           level <= std::max({tail, head, (tail + head + length) / 2});
}

// Puts points between those of `line` where the distance at the middle of a stretch is off its level by more than
// `tolerance` mm, until it is not, at most 63 for each stretch.
void refine(const Surface& surface, Isoline& line, const Inside& at, double tolerance);

// Those of an exact field: crossings solved from its windows, lines refined to 0.001 mm.  `begins`: gets where each of
// them begins.
std::vector<Isoline> isolines(const Surface& surface, const ExactField& field, std::span<const double> levels,
                              std::vector<OnEdge>* begins = nullptr);

// Those of values that are linear in every triangle.
std::vector<Isoline> isolines(const Surface& surface, std::span<const double> distance, std::span<const double> levels);

} // namespace filum::geodesic
