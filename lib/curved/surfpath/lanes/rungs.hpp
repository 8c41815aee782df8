// A ladder across neighbouring lanes: the coordinates in which links between lanes are drawn.
#pragma once

#include "geom/vec.hpp"
#include "surfpath/lanes/lanes.hpp"

namespace filum::surfpath::lanes {

using geom::Vec2;

// Rungs across neighbouring lanes, about `step` mm apart. The point (u, v) lies on rung v, between lane floor(u) of
// the ladder and the next; whole numbers u are on lanes.
struct Ladder {
    std::vector<std::uint32_t> lane;       // from the first lane on
    std::vector<double> sense;             // per lane: 1 if its arc length grows from rung to rung, otherwise -1
    std::vector<std::vector<double>> arcs; // per rung: the arc length on each lane
    double step = 0;                       // mm, on the first lane

    [[nodiscard]] std::size_t lanes() const { return lane.size(); }
    [[nodiscard]] double last() const { return static_cast<double>(arcs.size() - 1); } // v of the last rung
};

// One rung: a place on each of several neighbouring lanes.
struct Rung {
    std::vector<LanePlace> places;
    std::vector<double> sense; // of each lane, relative to the first
};
// The rung from `lane` at arc length `way` across its neighbours on one side, at most `farthest` spacings from lane to
// lane, over at most `most` lanes. It ends before it would meet a lane twice.
Rung rung(const Lanes& lanes, std::uint32_t lane, double arc, double side, double farthest, std::size_t most);

// Whether the second rung can be the next one of a ladder: the same lanes, farther on along each.
bool follows(const Lanes& lanes, const Rung& first, const Rung& second);

Ladder ladder(const std::vector<Rung>& rungs, double step);

// Arc length at v on lane number `k` of the ladder.
double arc_at(const Lanes& lanes, const Ladder& rungs, std::size_t k, double v);

Place place_at(const Lanes& lanes, const Ladder& rungs, Vec2 uv);

// The threaded line through points (u, v).
Line drawn(const Lanes& lanes, const Ladder& rungs, const std::vector<Vec2>& uv);

// The least length of a lane between the first and the last rung, mm.
double shortest(const Lanes& lanes, const Ladder& rungs);

} // namespace filum::surfpath::lanes
