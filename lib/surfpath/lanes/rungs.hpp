// A ladder across lanes: coordinates in which turns and changes of lanes are drawn.
#pragma once

#include "geom/vec.hpp"
#include "surfpath/lanes/lanes.hpp"

namespace filum::surfpath::lanes {

using geom::Vec2;

// Rungs across neighbouring lanes, about `step` mm apart.  A point (u, v) lies on rung v between the lanes floor(u) and
// floor(u) + 1, whole numbers being on them.
struct Rungs {
    std::vector<std::uint32_t> lane;       // from the first lane on
    std::vector<double> sense;             // per lane: 1 if its way grows with the rungs, else -1
    std::vector<std::vector<double>> ways; // per rung: the way on each lane
    double step = 0;                       // mm, on the first lane

    [[nodiscard]] std::size_t lanes() const { return lane.size(); }
    [[nodiscard]] double last() const { return static_cast<double>(ways.size() - 1); } // v of the last rung
};

// The rung from `lane` at `way` over to its neighbours on that side, up to `farthest` spacings apart, at most `most`
// lanes; ends before a lane that it has crossed already.
struct Rung {
    std::vector<LanePlace> places;
    std::vector<double> sense; // relative to the first
};
Rung rung(const Lanes& lanes, std::uint32_t lane, double way, double side, double farthest, std::size_t most);

// True if the second rung can follow the first: same lanes, and no way between them far from `step`.
bool follows(const Lanes& lanes, const Rung& first, const Rung& second, double step);

Rungs ladder(const std::vector<Rung>& rungs, double step);

// Way on lane number `k` at v.
double way_at(const Lanes& lanes, const Rungs& rungs, std::size_t k, double v);

Place place_at(const Lanes& lanes, const Rungs& rungs, Vec2 uv);

// The line through these points, threaded.
Line drawn(const Lanes& lanes, const Rungs& rungs, const std::vector<Vec2>& uv);

// The least length of lanes between the first and last rung, mm.
double shortest(const Lanes& lanes, const Rungs& rungs);

} // namespace filum::surfpath::lanes
