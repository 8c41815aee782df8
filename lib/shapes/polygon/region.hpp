// Layers and connected regions: the data that `slice`, `regions` and `sequence` pass on.
#pragma once

#include "base/join.hpp"
#include "polygon/loops.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace filum::polygon {

// The highest numbers of a tool and of a body.
inline constexpr std::uint32_t kMostTool = 1000, kMostBody = 100000;
// The most layers of the job that one layer of a tool may be high.
inline constexpr std::uint32_t kMostLayers = 16;

// One slice of the solid.
struct Layer {
    std::uint32_t index = 0;
    double z = 0;      // height of the nozzle, mm: the top of the layer
    double height = 0; // thickness, mm
    double plane = 0;  // height of the cut through the model, mm
    Loops contours;    // outer counter-clockwise, holes clockwise, simple
    // Several bodies: the layer comes once for each body. Areas of bodies with different tools do not overlap.
    std::uint32_t body = 0, tool = 0; // numbers of the body and of the tool that prints it
    double width = 0;                 // mm, of its beads; 0: as the stages' options say
    // The number of layers of the job that it is high; `index` is the uppermost of these.
    std::uint32_t layers = 1;
    std::uint32_t skipped = 0; // number of lower layers on which its body has no layer of its own for this reason
};

// How a region lies on one region of the layer below.
struct Overlap {
    std::uint32_t below = 0; // id of the lower region
    double area = 0;         // mm2
    double inradius = 0;     // mm; a circle of this radius fits into the common area (a lower bound)
    bool link = false;       // the curves that fill both regions come within about a bead width of each other here
};

// Kinds of areas within a region.
enum class AreaKind : std::uint8_t {
    skin_top,    // solid, seen from above
    skin_bottom, // solid, seen from below
    bridge,      // solid, over air between its supports; loops: the outline of the air
    sparse,      // filled with sparse infill
    zone,        // has walls and beads of its own
};

// How a sparse area is filled.
enum class InfillPattern : std::uint8_t {
    rows,       // straight lines
    wave,       // waves that shift from layer to layer, as a gyroid does
    concentric, // lines along the outline
};

// A part of a region that is filled in a way of its own. Its loops are simple; it may have several pieces. No two zones
// overlap.
struct Area {
    AreaKind kind = AreaKind::sparse;
    Loops loops;
    double direction = 0; // rad, of bridges and rows, from the x axis
    double spacing = 0;   // mm, sparse: distance between lines
    InfillPattern pattern = InfillPattern::rows;
    double gap = 0; // mm, sparse: the widest gap allowed, kept by extra lines; 0: no limit
    // zone: number of rings along its outline, within the rings of the whole region
    std::uint32_t walls = 0;
    double width = 0; // mm, of the beads of a zone, and of the lines of a sparse area; 0: as around it
    double solid = 0; // mm, of the beads of solid parts of a zone; 0: as the zone's other beads
};

// The purpose of a region.
enum class RegionClass : std::uint8_t {
    part,
    support, // carries overhangs; to be removed
    rim,     // beside the first layer, to be removed: brim and skirt
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
    double unsupported = 0;   // mm2, farther than half a bead from the layer below
    std::uint32_t stroke = 0; // set by `sequence`, as `join` is
    Join join = Join::start;
    double inradius = 0;     // mm; a circle of this radius fits into the region (a lower bound)
    Box2 box;                // of the outer loop
    std::vector<Area> areas; // set by `skins`; outside all areas the region is solid
    std::uint32_t walls = 0; // number of rings along the whole outline; 0: no separate walls, solid throughout
    RegionClass is = RegionClass::part;
    // id of a brim around it, set by `supports`; -1 if none. Its beads lie beside those of the region, so one stroke
    // may print both.
    std::int64_t brim = -1;
    // Number of its body (the lowest, if several became one region) and of the tool that prints it.
    std::uint32_t body = 0, tool = 0;
    double width = 0; // mm, of its beads; 0: as the stages' options say
    // As in Layer: the number of layers that it is high, and of layers without its body.
    std::uint32_t layers = 1, skipped = 0;

    // The layer on which it rests; -1: the bed.
    [[nodiscard]] std::int64_t rests_on() const {
        return static_cast<std::int64_t>(layer) - static_cast<std::int64_t>(layers);
    }
    // The number of the layer among those of its body: neighbours above each other differ by 1.
    [[nodiscard]] std::uint32_t own_layer() const { return layer - skipped; }
};

// The outlines of the material, per layer from the first to the last, of all regions or of one class (`only`). Empty
// for a missing layer. A region that is several layers high counts on each of them.
std::vector<Loops> materials(std::span<const Region> regions, std::optional<RegionClass> only = {});

} // namespace filum::polygon
