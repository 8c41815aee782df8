// The extruded material of a toolpath, sorted into layers: what coverage, crossings and turns are measured on.
#pragma once

#include "polygon/region.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace filum::metrics::planar {

using geom::Vec2;

// The place of a layer: nozzle heights in (z - height, z] belong to it.
struct LayerMark {
    std::uint32_t index = 0;
    double z = 0, height = 0; // mm
};

// A stretch of consecutive segments with one role in one region.
struct Piece {
    std::uint32_t first = 0; // of its points
    std::uint32_t region = 0;
    std::uint32_t order = 0; // of its first segment, counting all extruding segments of the program as printed
    toolpath::Role role = toolpath::Role::bead;
    bool continues = false; // begins, without a stop, where the piece before it ended
};

// Segments of one layer: piece k is points[pieces[k].first .. pieces[k + 1].first).
struct LayerBeads {
    double height = 0;         // mm
    std::vector<Vec2> points;  //
    std::vector<float> width;  // mm, of the segment from a point to the next
    std::vector<float> z;      // mm, of points; none if all lie as high as the first
    std::vector<float> thick;  // of the layer's height, of segments, as width; 1 of those behind the last
    double first_z = 0;        // mm
    std::vector<Piece> pieces; //

    [[nodiscard]] double thickness(std::size_t segment) const {
        return segment < thick.size() ? double{thick[segment]} : 1;
    }
    [[nodiscard]] std::size_t end(std::size_t piece) const {
        return piece + 1 < pieces.size() ? pieces[piece + 1].first : points.size();
    }
};

// All layers by number: 20 bytes per segment, 28 where they rise or are thinner than their layer.
struct Beads {
    std::vector<LayerMark> marks; // ascending z; empty if no Regions are known
    std::map<std::uint32_t, LayerBeads> layer;
    std::uint32_t segments = 0;  // so far
    std::uint64_t misplaced = 0; // segments above the top layer, counted there
    // where the last segment ended, to tell what continues
    geom::Vec3 at{};
    std::uint32_t last_layer = 0, last_region = 0;
    bool moving = false;
};

// Layers as the Regions tell: one mark per layer number.
std::vector<LayerMark> layer_marks(const std::vector<polygon::Region>& regions);

// Adds the extruding segments of `span`.  A segment belongs to the layer that its upper end falls into, whatever
// layer the span claims; only without marks the claim is taken.  Segments shorter than 1 nm in XY deposit nothing here.
void add(Beads& beads, const toolpath::Span& span);

// Adds the curves of a region, as if printed one after the other.
void add(Beads& beads, const toolpath::RegionPaths& paths);

} // namespace filum::metrics::planar
