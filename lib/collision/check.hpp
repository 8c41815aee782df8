// Whether the head meets anything on its way, and how near it comes (docs/algorithms/routing.md).
#pragma once

#include "collision/tree.hpp"

#include <optional>
#include <vector>

namespace filum::collision {

// From one stance straight to another: the tip at even speed, the axis turning evenly the short way (antiparallel
// axes: either way).
struct Move {
    Stance from, to;
    std::uint32_t before = 0; // beads born earlier stand in the way; see beads.hpp
    std::uint32_t source = 0; // a point of the toolpath, counted over all; a line of the program
    std::uint32_t layer = 0, stroke = 0;
    bool travel = false;
    std::uint32_t tool = 0; // whose head it is
};

enum class Against : std::uint8_t { beads, part, fixture, bed };
inline constexpr std::array<const char*, 4> kAgainstNames{"beads", "part", "fixture", "bed"};

struct Options {
    double step = 0.5;   // mm: no point of the head moves farther between two checks
    double press = 0.05; // mm: how far things may rise above the plane of the tip, and the head sink into beads
    double margin = 0;   // mm: what comes nearer collides
};

struct Place {
    std::size_t move = 0;
    double along = 0;     // share of the move
    double clearance = 0; // mm; a bead's may be negative
    Vec3 tip;
    Piece piece = Piece::nozzle;
    Against against = Against::beads;
};

struct Found {
    std::vector<Place> collisions;             // per move and kind of thing the worst, in order
    std::size_t moves = 0;                     // how many moves are among them
    std::array<std::optional<Place>, 4> least; // by Against: where the head comes nearest; nothing if nothing rises
};

// The things of each kind; those without any are empty trees.
using Scene = std::array<Tree, 4>;

// A collision is a place where the head comes nearer than the margin to a part, fixture or bed, touching at least, or
// enters a bead deeper than `press` less the margin.  Only what rises more than `press` above the plane through the tip
// across its axis counts: the rest lies under the head, which lies above that plane as a whole.
//
// A move is halved until the bounds of its motion show that nothing comes nearer than what was found already and than
// the margin asks, or that no point of the head that can move by more than `step` within the piece comes so near; then
// its middle is checked.  So no clearance is below the one given by more than half a step.
// Ties: the earlier move, then the earlier place.  The same for any number of threads (0: all cores).
Found check(const Scene& scene, const Heads& heads, const std::vector<Move>& moves, const Options& options,
            int threads);

// The stance at a share of a move.
Stance at(const Move& move, double along);

// What a whole move does to the head.
struct Motion {
    Vec3 way;                    // mm: of the tip
    double length = 0, turn = 0; // mm, rad: of the axis, and about it where that is known
};
Motion motion(const Move& move);

inline constexpr double kTouch = 1e-6; // mm: solid things may not be touched
inline constexpr int kHalvings = 40;   // of a move at most

// The plane z = 0 below all tips of `moves`, and 300 mm around.
std::vector<Solid> bed(const std::vector<Move>& moves);

} // namespace filum::collision
