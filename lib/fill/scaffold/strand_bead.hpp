// The walk through a scaffold's layer as a bead line.
#pragma once

#include "fill/scaffold/strand_walk.hpp"
#include "toolpath/path.hpp"

#include <span>

namespace filum::fill::scaffold {

// The open curve along `trail`, `width` wide; what all trails of the walk pass k times is laid in beads of width / k.
// Corners between strands and turns that are passed once are rounded, by cutting off at most `radius` mm and half of
// either side, and less where the bead would cross itself.  `passes` holds how often each strand (first) and arc
// (second) is passed, see below.
struct Passes {
    std::vector<std::uint32_t> strand, arc;
};
Passes passes(const StrandGraph& graph, const StrandWalk& walk);
toolpath::Curve strand_bead(const StrandGraph& graph, std::span<const Step> trail, const Passes& passes, double width,
                            double radius);

} // namespace filum::fill::scaffold
