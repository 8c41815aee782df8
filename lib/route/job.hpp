// A whole toolpath whose travels get a way of their own, and whose tool leans where that frees the head.
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
    bool bed = false; // z = 0 is there
};

struct Job {
    std::vector<toolpath::Span> spans;
    std::vector<Leaning> leaning;                       // strokes whose tool leans, in order
    std::array<std::size_t, kKindNames.size()> kinds{}; // travels, by Kind
    double before = 0, after = 0;                       // mm: of all travels, as they were and as they are
    // The check of all that comes out, as `collide` has it.
    std::vector<collision::Move> moves;
    collision::Found found;
};

// Takes what stands there from the start (by Against; of beads: none).  Spans stay as they are, but for these:
// travels between two strokes, as many as there are, become one that carries normals; a stroke in which the head
// collides may get normals that lean away from the ones it has, and points in between (tilt.hpp).  What goes before the
// first stroke stays.  Deterministic for any number of threads.
Job route(std::vector<toolpath::Span> spans, std::array<std::vector<collision::Solid>, 4> things,
          const Options& options, int threads);

} // namespace filum::route
