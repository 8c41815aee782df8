// How sharply fibres bend.
#pragma once

#include "metrics/surface/chains.hpp"

#include <span>

namespace filum::metrics::surface {

// rad.  The paper's figure (Kipping et al. 2022, 4.1.2): every chain resampled (see `resampled`), at every point but a
// chain's ends, where it is 0, the angle between the step to it and the step from it; the mean of the greatest
// hundredth of all these angles, at least of one.  The steps are normalised, which the formula in print lacks.
double paper_angle(const Fibres& fibres, double step);

// The curvature around a place of a chain, 1/mm, signed: geodesic to the left of the way, normal towards the side that
// the surface faces.
struct Bend {
    double length = 0; // mm of the chain that it stands for
    double geodesic = 0, normal = 0;
    bool hairpin = false;
    [[nodiscard]] double total() const { return std::hypot(geodesic, normal); }
};

struct Bends {
    std::vector<Bend> places; // every quarter of a step or so
    std::size_t turns = 0;    // of more than 90 degrees to one side within 16 steps
    struct Range {
        double from, to; // mm along the chain
    };
    std::vector<Range> around; // 8 steps around wherever such a turn is under way; ascending, apart
};

// Geodesic: at each point of the chain the polyline turns by an angle in the tangent plane.  It is taken as spread
// evenly over half of the stretches beside the point, but at most `step` mm each way, and the curvature at a place is
// what lies within `step` mm of it each way, divided by that length; nearer to a chain's ends: what it is a step inside
// of them, not counting the outer half of a stretch shorter than 2 steps.  So the figures do not depend on how evenly a
// curve's points lie if they are not farther apart than 2 steps: a circle of any points has its own radius.  A sharp
// corner of angle a counts as an arc of curvature a / (2 step).  Points within a thousandth of a step are one.
//
// Normal: by how much the surface's normal nods forward over the same stretch (Weingarten), not by the polyline, which
// on triangles bends at their sides only.
//
// `normals`: of the surface, unit, per point of the chain.
Bends bends(const Chain& chain, std::span<const Vec3> normals, double step);

} // namespace filum::metrics::surface
