// Exact geodesic distance on a triangulated surface: the length of the shortest path on the faces to the nearest
// source (docs/algorithms/geodesic.md).
#pragma once

#include "geodesic/sources.hpp"
#include "geodesic/window.hpp"

#include <limits>
#include <memory>
#include <span>

namespace filum::geodesic {

// A half-edge laid flat: its tail at the origin, its head at (length, 0), the triangle above it with its third corner
// at (cx, cy), cy > 0.
struct Frame {
    double length, cx, cy, inverse_length;
};
std::vector<Frame> frames(const Surface& surface);

// Point `p` of the triangle of half-edge `h`, in the frame of `h`.
geom::Vec2 flatten(const Surface& surface, const Frame& frame, std::uint32_t h, const Vec3& p);

// What distances on a surface need of it, whatever they are measured from.
struct Ground {
    std::vector<Frame> frame;          // per half-edge
    std::vector<std::uint32_t> across; // per half-edge: the one whose list holds what leaves the triangle there
    std::uint32_t lists = 0;           // of windows: one per half-edge, then one per side of a rim
    std::vector<char> spreads;         // per vertex: paths may bend there
    double mean_edge = 0;              // mm
};

// Distances from all sources at once, and how they come about.
struct ExactField {
    std::vector<double> distance; // per vertex, mm; infinite where no source is on the same component
    std::shared_ptr<const Ground> ground;

    // Per half-edge, windows that enter its triangle across it, without overlap; behind those of the half-edges, at
    // 3 * triangles + i, windows that reach the i-th side of the rims from within.
    Windows windows;
    std::vector<std::uint32_t> first; // per list: the window with the least b0, kNone if there is none
    std::vector<Segment> segments;    // the sources that are no vertices, by triangle
    std::uint64_t propagated = 0;     // windows in all, those replaced by nearer ones included
};

// Window propagation: windows cross triangles in the order of their distance, all that wait at one half-edge together
// (Mitchell, Mount, Papadimitriou 1987; the order by triangles: Qin et al. 2016, "Fast and exact discrete geodesic
// computation"), each list being the lower envelope of its windows, and windows that a path over a vertex beats are
// dropped (Xin, Wang 2009).  Segments are sources in their own right (Bommes, Kobbelt 2007): their windows have linear
// distances.  Exact up to rounding: 1e-9 of an edge per triangle crossed; but ends of segments that are nearer than
// 1e-7 of a triangle's longest side to a corner or a side count as on it.
// Ties: the window that came first.  Throws Error(failure) if more than 2^31 windows were needed.
// Stops when all is found that is nearer than `farthest` mm: other vertices are infinitely far then, and the windows
// are good for nothing beyond.  `ground` is that of another field on the same surface, if there is one.  Windows do not
// cross triangles that are `shut`, if any are told: distances are right where no shortest path leads through one.
ExactField exact(const Surface& surface, const Sources& sources,
                 double farthest = std::numeric_limits<double>::infinity(),
                 std::shared_ptr<const Ground> ground = nullptr, std::span<const char> shut = {});

// Per triangle, whether all of its corners are farther than `level`: to be shut, where lines of less are measured from
// and what lies on their nearer side is wanted.
std::vector<char> beyond(const Surface& surface, std::span<const double> distance, double level);

// Only the distances of the vertices, in a fraction of the memory: windows are given back once nothing that is still
// to come can be nearer.  Stops also after `most` windows, having found what is nearer than `known` then.
struct ExactDistances {
    std::vector<double> distance; // per vertex, as in ExactField
    double known = 0;             // mm; infinite if all was found
    std::uint64_t propagated = 0;
};
ExactDistances exact_distances(const Surface& surface, const Sources& sources,
                               double farthest = std::numeric_limits<double>::infinity(),
                               std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

} // namespace filum::geodesic
