// Exact geodesic distance on a triangulated surface: the length of the shortest path on the faces to the nearest
// source (docs/algorithms/geodesic.md).
#pragma once

#include "geodesic/sources.hpp"
#include "geodesic/window.hpp"

#include <limits>
#include <memory>
#include <span>

namespace filum::geodesic {

// A half-edge in the plane: its tail at the origin, its head at (length, 0), and its triangle above, with the third
// corner at (cx, cy), cy > 0.
struct Frame {
    double length, cx, cy, inverse_length;
};
std::vector<Frame> frames(const Surface& surface);

// Point `p` of the triangle of half-edge `h` in the frame of `h`.
geom::Vec2 flatten(const Surface& surface, const Frame& frame, std::uint32_t h, const Vec3& p);

// The data of a surface that all distance fields on it share.
struct Unfolding {
    std::vector<Frame> frame; // per half-edge
    // per half-edge: the number of the list for windows that leave its triangle there
    std::vector<std::uint32_t> across;
    std::uint32_t lists = 0;  // number of lists of windows: one per half-edge, then one per side of a rim
    std::vector<char> saddle; // per vertex: shortest paths may bend there
    double mean_edge = 0;     // mm
};

// Distances from the nearest of all sources, with the windows that determine them.
struct ExactField {
    std::vector<double> distance; // per vertex, mm; infinite on components without a source
    std::shared_ptr<const Unfolding> unfolding;

    // Lists of windows. List h < 3 * triangles: windows that enter the triangle of half-edge h across it. Lists 3 *
    // triangles + i: windows that reach the i-th side of the rims from inside. Windows of a list do not overlap.
    Windows windows;
    std::vector<std::uint32_t> first; // per list: the window with the least b0, kNone if it is empty
    std::vector<Segment> segments;    // sources other than vertices, by triangle
    std::uint64_t propagated = 0;     // number of windows created in total, including those that were replaced
};

// Window propagation (Mitchell, Mount, Papadimitriou 1987): windows cross triangles in the order of their distances,
// all pending windows of a half-edge together (Qin et al. 2016, "Fast and exact discrete geodesic computation"). Each
// list is the lower envelope of its windows; windows that are beaten by a path via a vertex are dropped (Xin, Wang
// 2009). Segments are sources as a whole, with windows of linear distance (Bommes, Kobbelt 2007).
// Exact up to rounding, about 1e-9 of an edge per triangle crossed; but ends of segments that are nearer than 1e-7 of
// a triangle's longest side to a corner or side are moved onto it. Ties: the window that came first. Throws
// Error(failure) if more than 2^31 windows are needed.
// Stops when everything nearer than `farthest` mm is found: other vertices get infinite distance, and windows are
// valid up to there. `unfolding` may be passed from another field on the same surface. Windows do not cross the
// triangles marked in `shut` (per triangle, or empty); distances are right where no shortest path leads through one.
ExactField exact(const Surface& surface, const Sources& sources,
                 double farthest = std::numeric_limits<double>::infinity(),
                 std::shared_ptr<const Unfolding> unfolding = nullptr, std::span<const char> shut = {});

// Per triangle whether all its corners are farther than `level`. To be used as `shut` if lines of lower level are
// sources and only their nearer side matters.
std::vector<char> triangles_beyond(const Surface& surface, std::span<const double> distance, double level);

// Computes only the distances of vertices, in a fraction of the memory: windows are freed once no later one can be
// nearer. Also stops after `most` windows; everything nearer than `known` is then final.
struct ExactDistances {
    std::vector<double> distance; // per vertex, as in ExactField
    double known = 0;             // mm; infinite if everything was found
    std::uint64_t propagated = 0;
};
ExactDistances exact_distances(const Surface& surface, const Sources& sources,
                               double farthest = std::numeric_limits<double>::infinity(),
                               std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

} // namespace filum::geodesic
