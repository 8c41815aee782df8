// How a tool has to lean along a stroke so that the head meets nothing (docs/algorithms/routing.md#leaning).
#pragma once

#include "collision/room.hpp"
#include "toolpath/path.hpp"

#include <span>
#include <vector>

namespace filum::route {

using geom::Vec3;

struct TiltOptions {
    double most = 0;   // rad off the normal; 0: not at all
    double rate = 0.1; // rad of that per mm of path
};

// How close to look.
struct Pace {
    double spacing = 1; // mm, between two places that are looked at
    bool every = false; // also at each point between, with the tilt of the nearest place
};

// A stroke: spans that follow each other without a travel, and per span and segment, what stands in its way (beads born
// earlier than `before`) and whether the head meets any of it.
struct Stroke {
    std::span<const toolpath::Span> spans;
    std::vector<std::vector<std::uint32_t>> before;
    std::vector<std::vector<bool>> blocked;
};

// Which stretches of the path the tool leans on, and how much.
struct Leaning {
    std::uint32_t stroke = 0, layer = 0;
    double length = 0, leaning = 0; // mm: of the stroke, and of what leans
    double most = 0, mean = 0;      // rad: mean over what leans
};

struct Leant {
    std::vector<toolpath::Span> spans;
    std::vector<std::vector<std::uint32_t>> origin; // per span and segment: the segment it was cut from
    std::vector<std::vector<bool>> stuck;           // per span and segment as given: near where none gave room
    Leaning leaning;
};

// Changes the normals of the spans (which then have some, (0, 0, 1) where there were none), and adds points, straight
// between those that are there, no farther apart than the pace's spacing near where the head is blocked.  Places and
// material stay.  Spans come back as they are if no tilt helps. Of all directions within `most` of the normal, in steps
// that get finer to a quarter of a degree, the tool takes those that make the integral of tilt^2 + (2 mm)^2 (change of
// tilt per mm)^2 along the stroke least, among those that leave the head without room on as little of the path as can
// be (where none of the first steps' tilts is free, finer ones are tried), and with the tilt changing by at most
// `rate`: dynamic programming over stations that far apart or more, and again about its result with half the steps.
// The tilt is measured in the frame that goes along the path without turning about the normal. Ties: the lesser tilt,
// then the one nearer to the path's direction.  The same for any number of threads.
Leant lean(const collision::Room& room, const Stroke& stroke, const TiltOptions& options, const Pace& pace,
           int threads);

} // namespace filum::route
