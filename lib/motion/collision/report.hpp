// Reports the result of a check as text and figures.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "collision/program.hpp"
#include "figures/figures.hpp"

#include <string>

namespace filum::collision {

// What `Move::source` counts: points of a toolpath or lines of a program.
enum class Source : std::uint8_t { point, line };

// A result with the data that reports need.
struct ReportInput {
    const std::vector<Move>& moves;
    const CheckResult& found;
    const Options& options;
    Source source = Source::point;
};

// The number of points or lines with collisions; several moves of one count once.
std::size_t colliding(const ReportInput& answer);

// The text of an Error: where the head first collides, and what to do. Precondition: there is a collision.
std::string complaint(const ReportInput& answer);

// The number of collisions of each kind, with place and depth of the worst.
Notes notes(const ReportInput& answer);

// Facts: moves, colliding-moves, step, and clearance-KIND of each kind that rises above the tip somewhere.
Facts facts(const ReportInput& answer);

// The same as figures with places.
figures::Figures summary(const ReportInput& answer);

// A line per collision: point or line, layer, stroke, bead or travel, kind of obstacle, piece of the head, clearance,
// position of the tip (mm), and the unit vector up the tool.
std::string places(const ReportInput& answer);

} // namespace filum::collision
