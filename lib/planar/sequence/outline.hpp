// Outlines of regions in trees, and whether the head over one region touches another.
#pragma once

#include "geom/capsule_tree.hpp"
#include "geom/vec.hpp"
#include "machine/head.hpp"
#include "polygon/loops.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace filum::sequence {

// The extent of the head around the nozzle up to some height above its tip: a disc, and a box centred on the nozzle.
struct Reach {
    double radius = 0;             // mm
    double half_x = 0, half_y = 0; // mm; 0 without a box
    bool everywhere = false;
    [[nodiscard]] double farthest() const; // upper bound in x and y
};

// The extent of `head` from its tip up to `dz` mm above it; without a head, a needle.
Reach reach(const machine::Head& head, double dz);

// A region's loops, and their edges in a tree.
struct Outline {
    polygon::Loops loops;
    geom::Box2 box;
    geom::CapsuleTree edges; // edge k leads from point k to the next one of its loop
};
Outline outline(polygon::Loops loops);
// The outline, moved by `way`.
Outline shifted(Outline outline, geom::Vec2 way);

// Whether a point of region a and a point of region b are within `r`, so that the head over one touches the other.
// Exact up to rounding; interiors count, so a region inside the other's outline has distance 0. Each vertex, pair of
// edges and pair of capsules that is looked at adds one to `steps`, if given.
bool within(const Outline& a, const Outline& b, const Reach& r, std::uint64_t* steps = nullptr);

// Lower and upper bound of a distance, mm.
struct Bounds {
    double least = 0, most = std::numeric_limits<double>::infinity();
};

// The distance between points of the regions, as far as it must be known to decide whether it is less than `limit`: the
// bounds differ by at most a quarter of the difference between the upper bound and the limit. So either both are less
// than the limit, or neither. The distance is 0 if the regions share a point. `known` are bounds that hold in any case;
// they save work. `steps` as for within().
Bounds distance_bounds(const Outline& a, const Outline& b, double limit, Bounds known = {},
                       std::uint64_t* steps = nullptr);

// The same for how far a point of one region is from a point of the other as a carriage sees it, mm: the carriage with
// these half sides touches if this is less than its shorter half side, the limit. Differences along the longer side
// count in proportion, so no point is farther away than its distance.
Bounds carriage_bounds(const Outline& a, const Outline& b, double half_x, double half_y, Bounds known = {},
                       std::uint64_t* steps = nullptr);

// The least distance between points of the regions; 0 if they share a point.
double distance(const Outline& a, const Outline& b);

} // namespace filum::sequence
