// The extruded material of a toolpath by layers: the input of coverage, crossings and turns.
#pragma once

#include "polygon/region.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace filum::metrics::planar {

using geom::Vec2;

// The range of heights of a layer: nozzle heights in (z - height, z] belong to it.
struct LayerMark {
    std::uint32_t index = 0;
    double z = 0, height = 0; // mm
};

// Consecutive segments with the same role in the same region.
struct BeadRun {
    std::uint32_t first = 0; // index of its first point
    std::uint32_t region = 0;
    std::uint32_t order = 0; // of its first segment, among all extruding segments in printing order
    toolpath::Role role = toolpath::Role::bead;
    bool continues = false;  // begins, without a stop, at the end of the run before
    std::uint8_t layers = 1; // the number of layers that its region is high
};

// The segments of one layer: run k is points[runs[k].first .. runs[k + 1].first).
struct LayerBeads {
    double height = 0;         // mm
    std::vector<Vec2> points;  //
    std::vector<float> width;  // mm, of the segment from a point to the next
    std::vector<float> z;      // mm, of points; empty if all have the z of the first
    std::vector<float> thick;  // fraction of the region's height, per segment as width; 1 beyond the last entry
    double first_z = 0;        // mm
    std::vector<BeadRun> runs; //

    [[nodiscard]] double thickness(std::size_t segment) const {
        return segment < thick.size() ? double{thick[segment]} : 1;
    }
    [[nodiscard]] std::size_t end(std::size_t run) const {
        return run + 1 < runs.size() ? runs[run + 1].first : points.size();
    }
};

// All layers by number: 20 bytes per segment, 28 if z or thickness vary.
struct Beads {
    std::vector<LayerMark> marks;                 // ascending z; empty without Regions
    std::map<std::uint32_t, std::uint8_t> layers; // of the regions that are several layers high: how many, by id
    std::map<std::uint32_t, LayerBeads> layer;
    std::uint32_t segments = 0;  // so far
    std::uint64_t misplaced = 0; // segments above the top layer, counted there
    // The end of the last segment, which determines whether a run continues.
    geom::Vec3 at{};
    std::uint32_t last_layer = 0, last_region = 0;
    bool moving = false;
};

// Layers as the Regions define them: one mark per layer number.
std::vector<LayerMark> layer_marks(const std::vector<polygon::Region>& regions);

// The regions that are several layers high, by id, with the number of these layers.
std::map<std::uint32_t, std::uint8_t> high_regions(const std::vector<polygon::Region>& regions);

// Adds the extruding segments of `span`. A segment belongs to the layer that contains its upper end, even if the
// span states another one; without marks, to the layer that the span states. Segments shorter than 1 nm in XY deposit
// nothing.
void add(Beads& beads, const toolpath::Span& span);

// Adds the curves of a region, in printing order.
void add(Beads& beads, const toolpath::RegionPaths& paths);

} // namespace filum::metrics::planar
