// Region outlines as trees of boxes, and whether the head over one of them touches the other.
#pragma once

#include "geom/vec.hpp"
#include "machine/head.hpp"
#include "polygon/loops.hpp"

#include <vector>

namespace filum::sequence {

// How far the head reaches around the nozzle at some height above its tip: a disc, and a box centred on the nozzle.
struct Reach {
    double radius = 0;             // mm
    double half_x = 0, half_y = 0; // mm, 0 if there is no box
    bool everywhere = false;
    [[nodiscard]] double farthest() const; // no point of the head is farther away in x or y
};

// The widest part of `head` from its tip up to `dz` mm above it; without a head, a needle.
Reach reach(const machine::Head& head, double dz);

// The edges of a region's loops in a tree of boxes.
struct Outline {
    polygon::Loops loops;
    std::vector<geom::Box2> box; // implicit binary tree over runs of edges: the children of i are 2i + 1 and 2i + 2
    std::size_t leaves = 0;      // a power of two
};
Outline outline(polygon::Loops loops);

// True if a point of region a and one of region b are nearer than `r` reaches: the head over one touches the other.
// Exact but for the rounding of doubles: interiors count, so a region inside the other's outline is at distance 0.
bool within(const Outline& a, const Outline& b, const Reach& r);

// The least distance between two points of the regions; 0 if they share one.
double distance(const Outline& a, const Outline& b);

} // namespace filum::sequence
