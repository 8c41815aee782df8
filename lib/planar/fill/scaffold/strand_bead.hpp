// Turns the walk through a layer of a scaffold into a bead line.
#pragma once

#include "fill/scaffold/strand_walk.hpp"
#include "toolpath/path.hpp"

#include <span>

namespace filum::fill::scaffold {

// How often a walk passes each strand and each arc.
struct Passes {
    std::vector<std::uint32_t> strand, arc;
};
Passes passes(const StrandGraph& graph, const StrandWalk& walk);

// The open curve along `trail`, `width` mm wide. A stretch that the walk passes k times, over all trails, gets beads of
// width / k. Corners between strands and turns that are passed once are rounded. Rounding cuts off at most `radius` mm
// and half of either side, and less where the bead would cross itself.
toolpath::Curve strand_bead(const StrandGraph& graph, std::span<const Step> trail, const Passes& passes, double width,
                            double radius);

} // namespace filum::fill::scaffold
