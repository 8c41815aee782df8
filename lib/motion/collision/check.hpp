// Checks whether the head collides on its way, and how near it comes (docs/algorithms/routing.md).
#pragma once

#include "collision/tree.hpp"

#include <optional>
#include <vector>

namespace filum::collision {

// A straight move from one stance to another: the tip at even speed, the axis rotating evenly by the shorter way (for
// antiparallel axes either way).
struct Move {
    ToolFrame from, to;
    std::uint32_t before = 0; // beads born earlier are obstacles; see beads.hpp
    std::uint32_t source = 0; // a point of the toolpath, counted over all, or a line of the program
    std::uint32_t layer = 0, stroke = 0;
    bool travel = false;
    std::uint32_t tool = 0; // the tool, which determines the head
};

enum class Obstacle : std::uint8_t { beads, part, fixture, bed };
inline constexpr std::array<const char*, 4> kAgainstNames{"beads", "part", "fixture", "bed"};

struct Options {
    double step = 0.5;   // mm: no point of the head moves farther between two checks
    double press = 0.05; // mm: how far obstacles may rise above the plane of the tip, and the head may sink into beads
    double margin = 0;   // mm: smaller clearances are collisions
};

// A place of small clearance.
struct Place {
    std::size_t move = 0;
    double along = 0;     // share of the move
    double clearance = 0; // mm; a bead's may be negative
    Vec3 tip;
    HeadPiece piece = HeadPiece::nozzle;
    Obstacle against = Obstacle::beads;
};

struct CheckResult {
    std::vector<Place> collisions; // per move and kind of obstacle the worst place, in order
    std::size_t moves = 0;         // number of moves with collisions
    // by Obstacle: the place of least clearance; none if no obstacle rises above the tip
    std::array<std::optional<Place>, 4> least;
};

// The obstacles of each kind; empty trees for kinds without obstacles.
using Scene = std::array<Tree, 4>;

// Checks moves. A collision is a place where the head comes nearer than the margin to a part, fixture or bed, or at
// least touches it, or enters a bead deeper than `press` less the margin. Only what rises more than `press` above the
// plane through the tip across its axis counts; the rest is below the head, which is entirely above that plane.
// A move is halved until its bounds show that nothing comes nearer than the least clearance found and than the margin,
// or that no point of the head that comes so near moves by more than `step` within the piece; then its middle is
// checked. So true clearances are less than those given by half a step at most.
// Ties: the earlier move, then the earlier place. The result does not depend on the number of threads (0: all cores).
CheckResult check(const Scene& scene, const Heads& heads, const std::vector<Move>& moves, const Options& options,
                  int threads);

// The stance at a share of a move.
ToolFrame at(const Move& move, double along);

// The extent of a whole move.
struct Motion {
    Vec3 way;                    // mm: of the tip
    double length = 0, turn = 0; // mm; rad: of the axis, and about it where known
};
Motion motion(const Move& move);

inline constexpr double kTouch = 1e-6; // mm: solid things must not be nearer
inline constexpr int kHalvings = 40;   // most halvings of a move

// The plane z = 0 below all tips of `moves`, and 300 mm around them.
std::vector<Solid> bed(const std::vector<Move>& moves);

} // namespace filum::collision
