// The lengths that all planners share. docs/algorithms/surfaces.md#lengths-that-planners-share derives them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace filum::surfpath::rules {

// ---- Lines side by side, one spacing apart. In spacings.

// Lines up to this far apart are neighbours: between lines that are farther apart one more line fits.
inline constexpr double kBeside = 2;
// Step between sample points of lines. A place half a spacing from a line seems at most 3 % farther away.
inline constexpr double kGrain = 0.25;
// Step between sample points where the area that beads cover is counted: such a place seems at most 1 % farther away.
inline constexpr double kFineGrain = kGrain / 2;
// How far a line may be moved off its place to round it: neighbours that both move are still 0.8 spacings apart. By the
// same share the spacing of a family of lines may change so that it ends where it should.
inline constexpr double kGive = 0.1;
// How far a line may be moved where else it turned tighter than the least radius: two neighbours that both move leave
// no room for another line between them.
inline constexpr double kMostGive = 0.25;

// Cost of an area that is covered twice, in areas that are left open, as `choose` weighs them.
inline constexpr double kOverlapCosts = 0.5;

// Slope, as a sine: a rim, or a line, that comes nearer to lines by less than this per mm runs along them (20 degrees).
// A hairpin at a rim that meets the lines at that angle leaves more than 4 square spacings open.
inline constexpr double kAlong = 1.0 / 3;

// Spacings by which turns lie on the innermost bead along a rim. Half turns side by side leave 1 - pi/4 square spacings
// per spacing of a rim at right angles open, so as much is covered twice as is left open.
inline constexpr double kOnRimBead = 1 - std::numbers::pi / 4;

// ---- Turns of a radius r.

// Radii: how much of a row a turn replaces, from where it leaves the row to its outermost place. A half turn is r
// deep, and its start bends off a row that it may meet at a slant.
inline constexpr double kTurnReach = 2;

// Radii of turns that are tried one after another, in least radii.
inline constexpr double kRadiusShares[] = {1, 0.5, 0.2};

// Least radii: the radius to which lines are rounded, so that their polylines on triangles keep the least radius when
// it is measured in steps of a quarter of a millimetre.
inline constexpr double kRounded = 1.1;

// mm: length over which a line shifts sideways by `by` mm, by two parabolas (shifted()) of this least radius.
inline double shift_length(double radius, double by) { return 2 * std::sqrt(radius * by); }

// The shift, as a share of the whole, after the share `t` of its length: two parabolas, the shift of least curvature.
inline double shifted(double t) { return t < 0.5 ? 2 * t * t : 1 - 2 * (1 - t) * (1 - t); }

// Length of a half circle, in diameters: half a turn over to the next line, in spacings, is no detour yet.
inline constexpr double kHalfTurn = std::numbers::pi / 2;

// Least radii: a turn is rounded to this, and measured as tight below it, so that rounding errors do not decide about
// turns of just the least radius.
inline constexpr double kSurely = 1.02;

// ---- Numerics.

// mm: how far a line may be off the surface, or beyond a bound, without a change.
inline constexpr double kOff = 0.01;
// A share of a surface, or of its vertices, that does not count.
inline constexpr double kNegligible = 0.01;
// Triangles per task.
inline constexpr std::size_t kTrianglesAtOnce = 256;
// A relaxation ends when no point moves farther than this in a sweep, in spacings or mean sides of triangles, or after
// so many sweeps.
inline constexpr double kRest = 1e-4;
inline constexpr int kMostSweeps = 2000;
// Limits of work. Searches that get better from round to round, and mostly end after a few rounds; steps of a search,
// up to some seconds; pieces that surfaces and rims are divided into.
inline constexpr int kMostRounds = 40;
inline constexpr std::uint64_t kMostSteps = 20'000'000;
inline constexpr std::size_t kMostPieces = 500'000;
// Smaller differences of shares, of lengths in mm, or of areas in mm2 are rounding.
inline constexpr double kRounding = 1e-9;

// mm: points nearer to each other than this are one point, and costs that differ by less are equal. Positions are
// computed to about 1e-9 mm.
inline constexpr double kSamePoint = 1e-6;
// Smaller angles, vectors in place of unit ones, and shares of an edge do not count: they are far above rounding, and
// far below what can be printed.
inline constexpr double kTiny = 1e-6;
// Spacings from the sources to the farthest place: more lines than this are refused.
inline constexpr double kMostLines = 10'000;

} // namespace filum::surfpath::rules
