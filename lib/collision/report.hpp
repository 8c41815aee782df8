// What was found about collisions, in words and figures.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "collision/program.hpp"
#include "metrics/figures/figures.hpp"

#include <string>

namespace filum::collision {

// What `Move::source` counts: points of a toolpath, or lines of a program.
enum class Source : std::uint8_t { point, line };

struct Answer {
    const std::vector<Move>& moves;
    const Found& found;
    const Options& options;
    Source source = Source::point;
};

// How many points or lines collide; one that was cut counts once.
std::size_t colliding(const Answer& answer);

// Where the head first collides, and what can be done: what an Error says.  Precondition: it does.
std::string complaint(const Answer& answer);

// How many collisions of each kind there are, with the place and depth of the worst.
Notes notes(const Answer& answer);

// moves, colliding-moves, step, and clearance-KIND of each kind that rises above the tip somewhere.
Facts facts(const Answer& answer);

// The same as figures, with places.
metrics::figures::Figures summary(const Answer& answer);

// A line per collision: the point or line, layer, stroke, bead or travel, what is met, with which piece of the head,
// clearance, where the tip is, mm, and the unit vector up the tool.
std::string places(const Answer& answer);

} // namespace filum::collision
