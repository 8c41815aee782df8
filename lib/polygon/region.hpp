// Layers and connected regions: what `slice`, `regions` and `sequence` hand on.
#pragma once

#include "base/join.hpp"
#include "polygon/loops.hpp"

#include <cstdint>
#include <optional>
#include <span>
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

// What a part of a region is.
enum class AreaKind : std::uint8_t {
    skin_top,    // solid, seen from above
    skin_bottom, // solid, seen from below
    bridge,      // solid, over air between what carries it; loops: the air
    sparse,      // filled in part
    zone,        // with walls and beads of its own
};

// How a sparse area is filled.
enum class Pattern : std::uint8_t {
    rows,       // straight lines
    wave,       // waves that shift from layer to layer, as a gyroid does
    concentric, // lines along the outline
};

// A part of a region that is not filled like the rest; simple, it may have several pieces.  No two zones overlap.
struct Area {
    AreaKind kind = AreaKind::sparse;
    Loops loops;
    double direction = 0; // rad, of bridges and of rows, from the x axis
    double spacing = 0;   // mm, sparse: from line to line
    Pattern pattern = Pattern::rows;
    double gap = 0; // mm, sparse: no gap is wider, by more lines between those; 0: as the spacing says
    // zone: rings along its outline, within those that the whole region has
    std::uint32_t walls = 0;
    double width = 0; // mm, zone: of its beads
};

// What a region is there for.
enum class RegionClass : std::uint8_t {
    part,
    support, // carries what overhangs, to be taken away
    rim,     // beside the first layer, to be taken away: brim and skirt
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
    double inradius = 0;     // mm; a circle of this radius fits into the region (a lower bound)
    Box2 box;                // of the outer loop
    std::vector<Area> areas; // set by `skins`: what is in none is solid
    std::uint32_t walls = 0; // rings along the whole outline; 0: none are told apart, and it is solid all through
    RegionClass is = RegionClass::part;
    // id of a brim about it, whose beads lie beside its own: one stroke may lay both; set by `supports`
    std::int64_t brim = -1;
};

// The material of every layer from the first to the last (of one class: `only`); none where a layer is missing.
std::vector<Loops> materials(std::span<const Region> regions, std::optional<RegionClass> only = {});

} // namespace filum::polygon
