// Tilts the tool along a stroke so that the head does not collide (docs/algorithms/routing.md#leaning).
#pragma once

#include "collision/room.hpp"
#include "toolpath/path.hpp"

#include <span>
#include <vector>

namespace filum::route {

using geom::Vec3;

struct TiltOptions {
    double most = 0;   // rad off the normal; 0: no tilt
    double rate = 0.1; // rad of tilt per mm of path
};

// Density of the places at which room is tested.
struct TestDensity {
    double spacing = 1; // mm between two places
    bool every = false; // also at each point in between, with the tilt of the nearest place
};

// Consecutive spans without a travel. Per span and segment: `before` (beads born earlier are obstacles), and whether
// the head collides on it.
struct Stroke {
    std::span<const toolpath::Span> spans;
    std::vector<std::vector<std::uint32_t>> before;
    std::vector<std::vector<bool>> blocked;
};

// How far and how much the tool is tilted on a stroke.
struct TiltSummary {
    std::uint32_t stroke = 0, layer = 0;
    double length = 0, leaning = 0; // mm: of the stroke, and of its tilted part
    double most = 0, mean = 0;      // rad: greatest tilt, and its mean over the tilted part
};

struct TiltedStroke {
    std::vector<toolpath::Span> spans;
    std::vector<std::vector<std::uint32_t>> origin; // per span and segment: the segment of the input
    std::vector<std::vector<bool>> stuck; // per span and segment of the input: near a place where no tilt gave room
    TiltSummary leaning;
};

// Changes the normals of the spans (adding (0, 0, 1) where there are none) and adds points on their segments, at most
// as far apart as `pace.spacing` near blocked places. Positions and material stay. Spans are returned unchanged if no
// tilt helps.
// Among all tilts up to `most`, in steps that are refined to a quarter of a degree, chooses those that leave the head
// without room on as little of the path as possible and then minimise the integral of tilt^2 + (2 mm)^2 (change of
// tilt per mm)^2, with the tilt changing by at most `rate`. Where no tilt of the first grid is free, finer grids are
// tried. Dynamic programming over stations at the distance that a change by a step needs, repeated around its result
// with half the step. Tilts are relative to a frame transported along the path without rotation about the normal.
// Ties: the smaller tilt, then the one nearer to the path's direction. The result does not depend on the number of
// threads.
TiltedStroke lean(const collision::Room& room, const Stroke& stroke, const TiltOptions& options,
                  const TestDensity& pace, int threads);

} // namespace filum::route
