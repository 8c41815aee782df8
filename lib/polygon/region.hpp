// Layers and connected regions: what `slice`, `regions` and `sequence` hand on.
#pragma once

#include "base/join.hpp"
#include "polygon/loops.hpp"

#include <cstdint>
#include <vector>

namespace filum::polygon {

// One slice of the solid.
struct Layer {
    std::uint32_t index = 0;
    double z = 0;      // height of the nozzle, mm: the top of the layer
    double height = 0; // thickness, mm
    double plane = 0;  // where the model was cut, mm
    Loops contours;    // outer counter-clockwise, holes clockwise, simple
};

// How a region lies on one region of the layer below.
struct Overlap {
    std::uint32_t below = 0; // id of the lower region
    double area = 0;         // mm2
    double inradius = 0;     // mm; a circle of this radius fits into the common area (a lower bound)
    bool link = false;       // the curves that fill both pass within about a bead width of each other here
};

// One connected region of a layer.
struct Region {
    std::uint32_t id = 0; // counts all regions of the part, layer by layer
    std::uint32_t layer = 0;
    double z = 0, height = 0; // as in Layer
    Loops loops;              // the outer loop, then the holes
    double area = 0;          // mm2
    std::int64_t parent = -1; // id of the region whose hole holds this one
    std::vector<Overlap> below;
    double unsupported = 0;   // mm2 with nothing below
    std::uint32_t stroke = 0; // set by `sequence`, as is join
    Join join = Join::start;
    double inradius = 0; // mm; a circle of this radius fits into the region (a lower bound)
    Box2 box;            // of the outer loop
};

} // namespace filum::polygon
