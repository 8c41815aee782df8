// Fewer moves for the same line: what lies within a tolerance of one straight move, or of one arc, becomes that.
#pragma once

#include "geom/segment_grid.hpp"
#include "toolpath/path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace filum::toolpath {

// No move that is shorter reaches a machine, mm.
inline constexpr double kLeastMove = 1e-3;

struct Tolerance {
    double path = 0; // mm between the line as given and as moved; 0: only points nearer than kLeastMove are merged
    double grid = 0; // mm: coordinates will be rounded to whole multiples of it, which is part of `path`
    // A move lays its mean cross-section all along.  That is within this share of the one that was given, at each
    // point, or what is laid so far is always right within this share of what a bead's width holds: a nozzle does no
    // better.
    double section = 0.05;
    bool arcs = false;
    double chord = 0; // mm: the machine cuts an arc into chords of at least this length; 0: into ones that do not count
};

// One move, straight or an arc in a level plane.
struct Move {
    Vec3 to;
    double length = 0;            // mm
    double volume = 0;            // mm3: all that was to be laid along the line as given
    double width = 0, height = 0; // mm, means
    double sweep = 0;             // rad of an arc, positive counter-clockwise seen from above; 0: straight
    Vec2 centre;                  // of an arc
    std::uint32_t first = 0;      // the segment of the span where it begins: segment i goes from point i to i + 1
};

struct Merged {
    std::vector<Move> moves; // from the span's first point to its last, which stay where they are
    double off = 0;          // mm, the farthest between both lines (Fréchet distance, from above, but for that)
};

// A chord of up to three bead widths may be off by all of the tolerance, one of length 2 by this share of it: the gap
// that it opens to its neighbours has no larger area.
inline double full_share(double width, double length2) { // mm, mm2
    const double full = 3 * width;
    return length2 <= full * full ? 1 : full / std::sqrt(length2);
}

// The moves that lay `span`: the Fréchet distance between the line as given and as moved is at most tolerance.path; up
// to three times kLeastMove more where points are nearer to each other than that.
// They end at points of the span: where it turns fast, ends beside it would make few and sharp corners of many slight
// ones, which a machine slows down for, and moves of beads side by side would open gaps.  Greedy: from each end the
// farthest point that one move reaches; level stretches by ordered stabbing of the discs around the points (Guibas,
// Hershberger, Mitchell, Snoeyink 1993), arcs with the best centre (Chebyshev); others by points alone.  No two moves
// cross each other, or one of `others`, where the line as given does not: there it stays as given.  So does all of a
// span that is no fill: others do not know where else it would be.
// Volumes add up to the span's.  Ties: the later point, a straight move before an arc.
Merged merge(const Span& span, const Tolerance& tolerance, std::span<const geom::Segment> others = {});

// The farthest of good, ..., last that fits, found by doubling the step and halving what failed; `good` fits.  Exact
// where all that is nearer than one that fits does, too; else one that fits and whose next does not, or `last`.
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

// Ascending indices of what is kept among `count`: the first, then from each the farthest with fits(from, to); the next
// one always fits.
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
