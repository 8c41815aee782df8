// Rings: closed lines along the middle of each lane of a region.
#pragma once

#include "fill/rings/beading.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace filum::fill::rings {

// Ring i has the points start[i] to start[i + 1] - 1; closed, the region's material on the left, without crossings.
struct Rings {
    std::vector<Vec2> points;
    std::vector<double> width; // mm, per point: of the lane there
    std::vector<std::uint32_t> start{0};
    std::vector<int> lane; // per ring, from 1 at the outline, ascending; 0: an open line rather than a ring

    [[nodiscard]] std::size_t size() const { return lane.size(); }
    void add(const Rings& more);
    void add(const toolpath::Curve& ring, int of_lane);
};

// What becomes of a ring as soon as it is traced: not all points of all rings are kept, which would need much memory.
// Called on several threads at once.
using RingWork = std::function<toolpath::Curve(const toolpath::Curve& ring)>;

// The rings of lanes 1 to `most` (0: all), lane by lane, as `work` returns them; groups of lanes on all cores. Arcs
// deviate by at most `tolerance` mm. Inner rings with a bead of at most `least_void` mm2 are left out.
Rings trace_rings(const Beading& beading, int most, double least_void, double tolerance, const RingWork& work);

} // namespace filum::fill::rings
