// The curvature of fibres.
#pragma once

#include "metrics/surface/fibres.hpp"

#include <span>

namespace filum::metrics::surface {

// rad. The paper's figure (Kipping et al. 2022, 4.1.2): every chain is resampled (see `resampled`); at each point the
// angle between the step to it and the step from it, 0 at the ends of a chain; the mean of the greatest hundredth of
// all these angles, at least of one. The steps are normalised, which the formula in print omits.
double paper_angle(const Fibres& fibres, double step);

// The curvature at a place of a chain, 1/mm, signed: geodesic positive to the left in the direction of travel, normal
// positive towards the side that the surface faces.
struct Bend {
    double length = 0; // mm of the chain for which it is representative
    double geodesic = 0, normal = 0;
    [[nodiscard]] double total() const { return std::hypot(geodesic, normal); }
};

struct Bends {
    std::vector<Bend> places; // about every quarter of a step
    std::size_t turns = 0;    // turns of more than 90 degrees to one side within 16 steps
    struct Range {
        double from, to; // mm along the chain
    };
    std::vector<Range> around; // 8 steps on both sides of every place in such a turn; ascending, disjoint
};

// Geodesic: at each point of the chain the polyline turns by an angle in the tangent plane. This angle is spread
// evenly over half of the segments next to the point, but at most `step` mm in each direction. The curvature at a
// place is the angle within `step` mm of it in each direction, divided by that length; nearer to the ends of a chain,
// the value one step inside of them, not counting the outer half of a segment shorter than 2 steps. So the figures do
// not depend on how evenly the points of a curve are distributed if they are at most 2 steps apart: a polyline of any
// points of a circle has the radius of the circle. A sharp corner of angle a counts as an arc of curvature a / (2
// step). Points within a thousandth of a step count as one.
// Normal: the rotation of the surface's normal about the axis across the path, over the same length (Weingarten), not
// the angle of the polyline, which on triangles turns at their sides only.
//
// `normals`: of the surface, unit, per point of the chain.
Bends bends(const Fibre& chain, std::span<const Vec3> normals, double step);

} // namespace filum::metrics::surface
