// Precedence from collisions: regions that must be printed before others because the head would touch these.
#pragma once

#include "machine/heads.hpp"
#include "sequence/graph.hpp"
#include "sequence/outline.hpp"

namespace filum::sequence {

// The work of measuring distances between regions, in steps of within() and distance_bounds(). Half of the limit may be
// used at any time; the rest in the share of the regions that are done. Beyond it, a distance that bounds do not decide
// counts as a collision: this adds precedences, and all of them lead upwards, so it can cost strokes but never a
// collision.
struct DistanceWork {
    std::uint64_t limit = 80'000'000;
    std::uint64_t steps = 0;           // used
    std::uint64_t assumed = 0;         // collisions that were not measured
    std::size_t done = 0, regions = 0; // regions that were looked at, and all of them
    [[nodiscard]] bool may_measure() const;
};

// Pairs (v, u) with v below u: if u is printed, the head over v touches it, so v must come first. That is the case if
// within(u, v, reach(head, z of u - z of v)). Pairs implied by others and by support (along columns and at the foot of
// a column) are left out: per region and other column only the lowest such u is given. The head is that of the tool
// that prints v. The heads of idle tools on its carriage count, too: they are beside it by Heads::Idle::shift. Throws
// Error(usage) if the tip of an idle tool is lower than the tip in use, as it would touch what is just printed.
std::vector<Pair> collisions(const Graph& g, const Columns& columns, const std::vector<Outline>& outlines,
                             const machine::Heads& heads, DistanceWork& work);
inline std::vector<Pair> collisions(const Graph& g, const Columns& columns, const std::vector<Outline>& outlines,
                                    const machine::Heads& heads) {
    DistanceWork work;
    return collisions(g, columns, outlines, heads, work);
}

} // namespace filum::sequence
