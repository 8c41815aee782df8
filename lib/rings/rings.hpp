// Rings: the lanes of a region as closed lines, each along the middle of its strip.
#pragma once

#include "rings/beading.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace filum::rings {

// Ring i has the points start[i] .. start[i + 1]; closed, solid on the left, none crossing another or itself.
struct Rings {
    std::vector<Vec2> points;
    std::vector<double> width; // mm, per point: of the strip there
    std::vector<std::uint32_t> start{0};
    std::vector<int> lane; // per ring, counted from 1 along the outline; ascending; 0: no ring but an open line

    [[nodiscard]] std::size_t size() const { return lane.size(); }
    void add(const Rings& more);
    void add(const toolpath::Curve& ring, int of_lane);
};

// What becomes of a ring, which is not kept: all points of all rings at once would be many.
using Laid = std::function<void(const toolpath::Curve& ring, int lane)>;

// Lays the rings of lanes 1 to `most` (all: 0), lane by lane.  Arcs are off by at most `tolerance` mm.  Rings inside
// others that would lay no more than `least_void` mm2 are left out.
void lay_rings(const Beading& beading, int most, double least_void, double tolerance, const Laid& laid);

} // namespace filum::rings
