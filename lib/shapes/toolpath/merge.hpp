// Reduces the number of moves of a line: parts within a tolerance of one straight move, or of one arc, become that
// move.
#pragma once

#include "geom/segment_grid.hpp"
#include "toolpath/path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace filum::toolpath {

// mm: no shorter move is written to a program.
inline constexpr double kLeastMove = 1e-3;

struct Tolerance {
    // mm: distance of the merged line from the given one; 0: only points nearer than kLeastMove are merged
    double path = 0;
    double grid = 0; // mm: coordinates will be rounded to whole multiples of it; included in `path`
    // A move has one cross-section, the mean. It is within this fraction of the given section at each point; or at
    // every point the volume so far differs from the given one by at most this fraction of the volume of one bead
    // width, which is the accuracy of a nozzle.
    double section = 0.05;
    bool arcs = false;
    // mm: least length of the chords into which the machine divides an arc; 0: their error is negligible
    double chord = 0;
};

// One move: straight, or an arc in a horizontal plane.
struct Move {
    Vec3 to;
    double length = 0;            // mm
    double volume = 0;            // mm3: total volume along the given line
    double width = 0, height = 0; // mm, means
    double sweep = 0;             // rad of an arc, positive counter-clockwise seen from above; 0: straight
    Vec2 centre;                  // of an arc
    std::uint32_t first = 0;      // the segment of the span in which it begins: segment i connects points i and i + 1
};

// What a merge has found, from which its moves can be made again without a search: four bytes for most moves.
struct MergeSteps {
    struct Turn {
        std::uint32_t step; // which one is this arc
        Vec2 centre;
        double sweep;
    };
    std::vector<std::uint32_t> begins; // points at which steps begin
    std::vector<Turn> turns;           // by step
    double off = 0;                    // that of the result
};

struct MergeResult {
    std::vector<Move> moves; // from the first point of the span to its last, which do not change
    double off = 0;          // mm: upper bound of the Fréchet distance of both lines
    MergeSteps steps;
};

// A chord of up to three bead widths may deviate by the whole tolerance, one of squared length `length2` by this
// fraction of it, so that the gap to its neighbours has no larger area.
inline double full_share(double width, double length2) { // mm, mm2
    const double full = 3 * width;
    return length2 <= full * full ? 1 : full / std::sqrt(length2);
}

// Moves that replace `span`. The Fréchet distance from the given line is at most tolerance.path; up to three times
// kLeastMove more where points are nearer to each other than that. Moves end at points of the span: in tight turns
// other ends would turn many slight corners into few sharp ones, where a machine slows down, and moves of adjacent
// beads would open gaps. Greedy: each move reaches the farthest possible point. Horizontal parts: ordered stabbing of
// the discs around the points (Guibas, Hershberger, Mitchell, Snoeyink 1993), arcs with the best centre (Chebyshev);
// other parts: by points only. Moves do not cross each other, or one of `others`, where the given line does not: there
// the line stays as given. Spans that do not fill also stay as given, because their new place would not be known to
// other spans. The sum of volumes stays the same. Ties: the later point, a straight move before an arc.
MergeResult merge(const Span& span, const Tolerance& tolerance, std::span<const geom::Segment> others = {});

// The result of merge() that had these steps, for the same span; it has none itself.
MergeResult merge_again(const Span& span, const MergeSteps& steps);

// The farthest of good, ..., last that fits, by doubling the step and then bisecting; `good` fits. Exact if every
// value below one that fits also fits; otherwise a value that fits and whose successor does not, or `last`.
template <class F>
std::uint32_t farthest(std::uint32_t good, std::uint32_t last, F&& fits) {
    for (std::uint32_t step = 1, bad = last + 1; good + 1 < bad;) {
        const std::uint32_t probe = std::min(good + step, bad - 1);
        if (fits(probe)) {
            good = probe;
            step *= 2;
        } else {
            bad = probe;
            step = 1;
        }
    }
    return good;
}

// Ascending indices of the kept ones of `count` elements: the first, then from each the farthest with fits(from, to);
// the next element always fits.
template <class F>
std::vector<std::uint32_t> greedy_steps(std::uint32_t count, F&& fits) {
    std::vector<std::uint32_t> out;
    for (std::uint32_t at = 0; at < count;) {
        out.push_back(at);
        if (at + 1 == count) break;
        at = farthest(at + 1, count - 1, [&](std::uint32_t to) { return fits(at, to); });
    }
    return out;
}

} // namespace filum::toolpath
