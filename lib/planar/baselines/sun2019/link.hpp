// The links of S. Sun, Y. Yao, Y. Jiang, "A 3D Continuous Path Generation Method and Evaluation for Fused Deposition
// Manufacturing in Tissue Engineering", 2019, section 3.3, exactly as described there, for comparison.  Nothing is
// checked: links may cross beads, and connectors pass through the part, where material overlaps.
//
// Where the text leaves room, these readings are used:
//  - "find starting point at or near the intersection of the out contour" (Figure 6): a closed curve begins where the
//    axis of greatest variance of its points leaves it, towards +x (+y if upright), and ends in the same point.  An
//    open one is printed from its first point to its last.
//  - "we adjust the starting point of the continuous path in each layer": the start of a closed curve moves on along it
//    by `start_shift` from layer to layer.
//  - "we connect the end point of the current layer with the starting point of the next layer by extruding continuous
//    filament and lifting Z-axis": straight up, then straight to the start, as a full bead.  So wherever the input says
//    that a stroke climbs.
//  - "plan the connection path from the outside of the maximum bounding box of the structure": wherever else; straight
//    out of the box of everything to be printed, around it the shorter way, straight in.
//  - a region that fell into several curves: a break between them.
#pragma once

#include "link3d/linker.hpp"

namespace filum::baselines::sun2019 {

struct LinkOptions {
    double start_shift = 0; // mm per layer
};

// Takes the regions in processing order; emits the spans in printing order at the end, when the box is known.
class Linker {
  public:
    explicit Linker(const LinkOptions& options) : options_(options) {}

    void add(toolpath::RegionPaths region, const link3d::Linker::Emit& /*at the end*/, Notes& /*none*/) {
        regions_.push_back(std::move(region));
    }
    void finish(const link3d::Linker::Emit& emit, Notes& notes);
    [[nodiscard]] const link3d::Counts& counts() const { return counts_; }

  private:
    void reach(const toolpath::RegionPaths& r, bool first, geom::Vec2 start, const link3d::Linker::Emit& emit);
    void go(const toolpath::RegionPaths& r, toolpath::Role role, std::vector<geom::Vec3> points,
            std::vector<double> width, const link3d::Linker::Emit& emit);

    LinkOptions options_;
    std::vector<toolpath::RegionPaths> regions_;
    link3d::Counts counts_;
    geom::Box2 box_; // of all curves
    std::optional<geom::Vec3> at_;
    std::uint32_t stroke_ = 0;
};

// The closed curve as an open line that starts where the axis of its points leaves it, moved on by `shift` mm, and
// ends at the same point; one bead's width per point.
link3d::Bead from_axis(const toolpath::Curve& curve, double shift);

} // namespace filum::baselines::sun2019
