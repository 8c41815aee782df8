// Routes a whole toolpath: computes ways for travels, and tilts the tool where that avoids collisions.
#pragma once

#include "collision/beads.hpp"
#include "route/tilt.hpp"
#include "route/travel.hpp"

#include <array>
#include <vector>

namespace filum::route {

struct Options {
    collision::Machine machine;
    collision::Options check;
    TravelOptions travel;
    TiltOptions tilt;
    bool bed = false; // whether z = 0 is an obstacle
};

struct RoutedToolpath {
    std::vector<toolpath::Span> spans;
    std::vector<TiltSummary> leaning;                   // strokes on which the tool is tilted, in order
    std::array<std::size_t, kKindNames.size()> kinds{}; // number of travels by Kind
    double before = 0, after = 0;                       // mm: total length of travels in the input and in the result
    // The check of the result, as by `collide`.
    std::vector<collision::Move> moves;
    collision::CheckResult found;
};

// `things`: the obstacles present from the start, by Obstacle (no beads). Spans stay as they are, except: all travels
// between two strokes become one that carries normals; a stroke with collisions may get tilted normals and additional
// points (tilt.hpp). What precedes the first stroke stays. The result does not depend on the number of threads.
RoutedToolpath route(std::vector<toolpath::Span> spans, std::array<std::vector<collision::Solid>, 4> things,
                     const Options& options, int threads);

} // namespace filum::route
